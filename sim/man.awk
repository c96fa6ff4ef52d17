# man.awk - what `sphaera COMMAND --help` prints as a manual page
# SPDX-License-Identifier: Apache-2.0
#
# -v name=PAGE -v command=COMMAND -v version=TEXT. The first line is the usage, the next paragraph
# what it is for; option lines start with blanks and a dash, text of an option from column 29 on.
function plain(text) { # as roff takes it
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    sub(/^[.']/, "\\\\\\&&", text)
    return text
}
function heading(title) {
    if (section != title) print ".SH " title
    section = title
}
FNR == 1 {
    usage = $0
    sub(/^Usage: /, "", usage)
    next
}
FNR == 2 { about = $0; next }
about != "" && !named && NF && !/^ *-/ && !/^ *$/ { about = about " " $0; next }
!named {
    named = 1
    printf ".TH %s 1 \"\" \"%s\" \"User commands\"\n", toupper(name), version
    print ".SH NAME"
    short = about
    sub(/[.:].*/, "", short)
    print plain(name) " \\- " plain(tolower(substr(short, 1, 1)) substr(short, 2))
    print ".SH SYNOPSIS\n.B " plain(usage)
    print ".SH DESCRIPTION\n" plain(about)
}
match($0, /^ +-/) && RLENGTH <= 7 { # an option, and its text behind it or in the next lines
    heading("OPTIONS")
    option = $0
    sub(/^ +/, "", option)
    text = ""
    if (match(option, /   +/)) {
        text = substr(option, RSTART + RLENGTH)
        option = substr(option, 1, RSTART - 1)
    }
    print ".TP\n.B " plain(option)
    if (text != "") print plain(text)
    next
}
section == "OPTIONS" && match($0, /^ +/) && RLENGTH > 19 { sub(/^ +/, ""); print plain($0); next }
section == "OPTIONS" && /^ [^ ]/ { sub(/^ /, ""); print ".SS " plain($0); next }
/^$/ { print section == "OPTIONS" ? "" : ".PP"; next }
/^ / { print ".br\n" plain($0); next }
/^[A-Z]/ { if (section == "OPTIONS") heading("NOTES"); print plain($0); next }
{ print plain($0) }
