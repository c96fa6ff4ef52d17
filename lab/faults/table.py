# table.py - faults and who notices them, as a table of a page
# SPDX-License-Identifier: Apache-2.0


def cell(record, side, judges):
    """Where a side has the fault, and who notices it; `*`: in the longer target alone."""
    files = ", ".join(f"`{edit.file}`" for edit in record.edits if edit.side == side)
    mine = [f"{judge}{' *' if judge.more else ''}" for judge in judges
            if side in {edit.side for edit in record.side(judge)}]
    return f"{files}: {'; '.join(mine)}" if mine else ""


def tell(picked):
    print("| fault | rule | model | RTL | proof's own files |\n|---|---|---|---|---|")
    for record, judges in picked:
        print("|", record.name, "|", record.rule.replace("|", "\\|"), "|",
              " | ".join(cell(record, side, judges) for side in ("model", "rtl", "formal")), "|")
