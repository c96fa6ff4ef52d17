# gen_top.awk - VERSION, machine.def and top.def to what knows the registers of rt_top
# SPDX-License-Identifier: Apache-2.0
#
# lang=v: rt_top.vh; lang=c: sphaera_regs.h; lang=rdl: SystemRDL; lang=page: the table of the page.
function bad(text) {
    printf "%s:%d: %s\n", FILENAME, FNR, text >"/dev/stderr"
    failed = 1
    exit 1
}
function about(text) { sub(/^[^:]*: */, "", text); return text }
function hex(text, i, n) { # 0x1f as a number, in any awk
    if (text !~ /^0x[0-9a-f]+$/) bad("no number: " text)
    for (i = 3; i <= length(text); i++)
        n = 16 * n + index("0123456789abcdef", substr(text, i, 1)) - 1
    return n
}
function field(lsb, width, name, what) {
    lsb += 0
    width += 0
    if (name == "" || lsb + width > 32 || lsb < next_free) bad("bits of " reg[regs] " overlap")
    next_free = lsb + width
    f = regs SUBSEP (++fields[regs])
    f_lsb[f] = lsb; f_width[f] = width; f_name[f] = name; f_what[f] = what
}
BEGIN { core_errors = counters = 0 }
{ sub(/#.*/, "") }
$1 == "reg" { machine[$2] = $3; if ($2 + 0 > last_machine) last_machine = $2 + 0 }
$1 == "error" { core_error[core_errors] = $3; what = $4
    for (i = 5; i <= NF; i++) what = what " " $i
    core_error_what[core_errors++] = what }
$1 == "counter" || $1 == "count" {
    counter[$2] = $3; from = $1 == "count" ? 4 : 5; what = $from
    for (i = from + 1; i <= NF; i++) what = what " " $i
    counter_what[$2] = what
    if ($2 + 0 >= counters) counters = $2 + 1
}
FILENAME ~ /VERSION$/ && split($1, part, ".") == 3 {
    release = sprintf("0x%04x%04x", part[1], part[2])
}
$1 == "top" {
    if (only) bad("no register stands behind one of " only " alone")
    if ($4 !~ /^(ro|rw|wo|w1c)$/) bad("access is ro, rw, wo or w1c")
    if (hex($2) % 4 || (regs && hex($2) <= hex(offset[regs]))) bad("offset " $2)
    offset[++regs] = $2; reg[regs] = $3; access[regs] = $4
    reset[regs] = $5 == "release" ? release : $5
    said[regs] = about($0); next_free = 0
    if ($3 == "ERRORS")
        for (e = 0; e < core_errors; e++) field(e, 1, core_error[e], core_error_what[e])
}
$1 == "only" {
    if ($2 != "LAYERS" || access[regs] != "rw") bad("only LAYERS, of a setting")
    only = $2
}
$1 == "bits" { field($2, $3, $4, about($0)) }
$1 == "place" { place[$3] = $2 }
function verilog(i, j, set, settings, resets, at, kept, mask, fixed, n_fixed) {
    print "// rt_top.vh - generated from top.def and machine.def by gen_top.awk; do not edit"
    print "// SPDX-License-Identifier: Apache-2.0"
    print "`ifndef RT_TOP_VH\n`define RT_TOP_VH"
    for (i = 1; i <= regs; i++) {
        printf "`define RT_TOP_%s 12'h%s\n", reg[i], substr(offset[i], 3)
        if (reset[i] != "built")
            printf "`define RT_TOP_%s_RESET 32'h%s\n", reg[i], substr(reset[i], 3)
        for (j = 1; j <= fields[i]; j++) {
            f = i SUBSEP j
            if (f_width[f] == 1) printf "`define RT_TOP_%s_%s %d\n", reg[i], f_name[f], f_lsb[f]
            else printf "`define RT_TOP_%s_%s %d:%d\n", reg[i], f_name[f],
                        f_lsb[f] + f_width[f] - 1, f_lsb[f]
        }
    }
    for (i = regs; i >= 1; i--) # from the highest down, as in a concatenation
        if (access[i] == "rw") {
            settings++
            resets = resets sprintf("%s32'h%s", resets ? ", " : "", substr(reset[i], 3))
            at = at sprintf("%s12'h%s", at ? ", " : "", substr(offset[i], 3))
            mask = fields[i] ? 0 : 2 ^ 32 - 1
            for (j = 1; j <= fields[i]; j++)
                mask += (2 ^ f_width[i, j] - 1) * 2 ^ f_lsb[i, j]
            kept = kept sprintf("%s32'h%08x", kept ? ", " : "", mask)
        } else fixed = fixed sprintf("%s12'h%s", n_fixed++ ? ", " : "", substr(offset[i], 3))
    for (i = 1; i <= regs; i++)
        if (access[i] == "rw") {
            printf "`define RT_TOP_SET_%s %d:%d\n", reg[i], 32 * set + 31, 32 * set
            for (j = 1; j <= fields[i]; j++)
                printf "`define RT_TOP_SET_%s_%s %d:%d\n", reg[i], f_name[i, j],
                       32 * set + f_lsb[i, j] + f_width[i, j] - 1, 32 * set + f_lsb[i, j]
            set++
        }
    printf "`define RT_TOP_SETTINGS %d\n`define RT_TOP_SETTINGS_RESET {%s}\n", settings, resets
    printf "`define RT_TOP_SETTINGS_OF_LAYERS %d\n", only != ""
    printf "`define RT_TOP_OTHERS %d\n`define RT_TOP_OTHERS_AT {%s}\n", n_fixed, fixed
    printf "`define RT_TOP_SETTINGS_KEPT {%s}\n`define RT_TOP_SETTINGS_AT {%s}\n", kept, at
    split("MACHINE COUNTERS", order, " ")
    for (i = 1; i <= 2; i++)
        printf "`define RT_TOP_%s 12'h%s\n", order[i], substr(place[order[i]], 3)
    for (i = 32; i < counters; i++) printf "`define RT_TOP_COUNT_%s %d\n", counter[i], i
    printf "`define RT_TOP_COUNTS %d\n`endif\n", counters
}
function header(i, j, errors) {
    print "/* sphaera_regs.h - generated from top.def and machine.def by gen_top.awk; do not edit"
    print " * SPDX-License-Identifier: Apache-2.0\n */"
    print "#ifndef SPHAERA_REGS_H\n#define SPHAERA_REGS_H\n"
    for (i = 1; i <= regs; i++) {
        printf "#define SPHAERA_%s %su /* %s: %s */\n", reg[i], offset[i], access[i], said[i]
        if (reset[i] != "built") printf "#define SPHAERA_%s_RESET %su\n", reg[i], reset[i]
        for (j = 1; j <= fields[i]; j++) {
            f = i SUBSEP j
            printf "#define SPHAERA_%s_%s_LSB %du\n", reg[i], f_name[f], f_lsb[f]
            printf "#define SPHAERA_%s_%s 0x%08xu /* %s */\n", reg[i], f_name[f],
                   (2 ^ f_width[f] - 1) * 2 ^ f_lsb[f], f_what[f]
        }
    }
    printf "\n#define SPHAERA_MACHINE %su\n#define SPHAERA_MACHINE_REGISTERS %du\n",
           place["MACHINE"], last_machine + 1
    printf "#define SPHAERA_COUNTERS %su\n#define SPHAERA_COUNTS %du\n\n",
           place["COUNTERS"], counters
    for (i = 0; i <= last_machine; i++)
        if (i in machine) printf "#define SPHAERA_REG_%s %du\n", machine[i], i
    print ""
    for (i = 0; i < counters; i++)
        if (i in counter) printf "#define SPHAERA_COUNT_%s %du\n", counter[i], i
    print "\n/* X(bit of ERRORS, what it says) */\n#define SPHAERA_EACH_ERROR(X) \\"
    for (i = 1; i <= regs; i++)
        for (j = 1; reg[i] == "ERRORS" && j <= fields[i]; j++) {
            f = i SUBSEP j
            printf "    X(SPHAERA_ERRORS_%s, \"%s\")%s\n", f_name[f], f_what[f],
                   (j < fields[i] ? " \\" : "")
        }
    print "\n#endif"
}
function rdl_reg(name, where) { printf "    } %s @ %s;\n", name, where }
function rdl_field(sw, name, lsb, width, value, desc, more) {
    printf "        field { desc = \"%s\"; sw = %s; hw = %s;%s } %s[%d:%d]%s;\n", desc, sw,
           (sw == "r" ? "w" : more ~ /onwrite/ ? "rw" : "r"), more, name, lsb + width - 1, lsb,
           (value == "" ? "" : sprintf(" = 0x%x", value))
}
function rdl(i, j, f, sw, more, value) {
    print "// rt_top.rdl - generated from top.def and machine.def by gen_top.awk; do not edit"
    print "// SPDX-License-Identifier: Apache-2.0"
    print "addrmap rt_top {\n    name = \"rt_top\";"
    print "    default regwidth = 32;\n    default accesswidth = 32;\n    addressing = compact;"
    for (i = 1; i <= regs; i++) {
        printf "    reg {\n        desc = \"%s\";\n", said[i]
        sw = access[i] == "ro" ? "r" : access[i] == "wo" ? "w" : "rw"
        more = access[i] == "w1c" ? " onwrite = woclr;" : access[i] == "wo" ? " singlepulse;" : ""
        if (!fields[i])
            rdl_field(sw, "VALUE", 0, 32, reset[i] == "built" ? "" : hex(reset[i]), said[i], more)
        for (j = 1; j <= fields[i]; j++) {
            f = i SUBSEP j
            value = reset[i] == "built" ? "" : \
                    int(hex(reset[i]) / 2 ^ f_lsb[f]) % 2 ^ f_width[f]
            rdl_field(sw, f_name[f], f_lsb[f], f_width[f], value, f_what[f], more)
        }
        rdl_reg(reg[i], offset[i])
    }
    for (i = 0; i <= last_machine; i++)
        if (i in machine) {
            print "    reg {"
            rdl_field("rw", "VALUE", 0, 32, 0, "register " i " of the machine", "")
            rdl_reg("M_" machine[i], sprintf("0x%03x", hex(place["MACHINE"]) + 4 * i))
        }
    for (i = 0; i < counters; i++)
        if (i in counter)
            for (j = 0; j < 2; j++) {
                print "    reg {"
                rdl_field("r", "VALUE", 0, j ? 16 : 32, "", counter_what[i], "")
                rdl_reg("C_" counter[i] (j ? "_HIGH" : "_LOW"),
                        sprintf("0x%03x", hex(place["COUNTERS"]) + 8 * i + 4 * j))
            }
    print "};"
}
function page(i, j, f) {
    print "| offset | register | access | reset | bits | |\n|---|---|---|---|---|---|"
    for (i = 1; i <= regs; i++) {
        printf "| %s | `%s` | %s | %s | | %s |\n", offset[i], reg[i], access[i], reset[i], said[i]
        for (j = 1; j <= fields[i]; j++) {
            f = i SUBSEP j
            printf "| | `%s` | | | %s%d | %s |\n", f_name[f],
                   (f_width[f] > 1 ? f_lsb[f] + f_width[f] - 1 ".." : ""), f_lsb[f], f_what[f]
        }
    }
    printf "| %s + 4n | machine register n | rw | 0 | | n = 0..%d of " \
           "[core.md](core.md#registers) |\n", place["MACHINE"], last_machine
    printf "| %s + 8n | counter n, low word | ro | | | of the last SNAPSHOT; 0..31: [core.md]" \
           "(core.md#counters) |\n", place["COUNTERS"]
    print "| + 4 | its high 16 bits | ro | | | |"
    for (i = 32; i < counters; i++)
        printf "| | counter %d `%s` | | | | %s |\n", i, counter[i], counter_what[i]
}
END {
    if (failed) exit 1
    if (lang == "v") verilog()
    if (lang == "c") header()
    if (lang == "rdl") rdl()
    if (lang == "page") page()
}
