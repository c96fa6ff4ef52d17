# port_fields.awk - fields of bundles beside the ports of modules, in lines that begin with //:
# SPDX-License-Identifier: Apache-2.0
#
# usage: awk [-v check=1] -f sim/port_fields.awk cmodel/machine/machine.def rtl/engine/bundles.def \
#            FILE...
# Prints the files with these lines made anew, as in a concatenation: the highest bits first, behind
# a name its bits if they are more than one. A bundle's fields stand once in a list of ports, below
# the first ports that have it. With check it prints FILE:LINE for each line that is not so.
function tell(text, line, word, n, i) {
    n = split(fields[pending], word, " ")
    line = "    //: {"
    for (i = n; i >= 1; i--) {
        text = word[i] (i > 1 ? "," : "}")
        if (length(line text) > 99) {
            put(line)
            line = "    //: "
        }
        line = line (line ~ /[{ ]$/ ? "" : " ") text
    }
    put(line)
    pending = ""
}
function put(line) { # a line that has to stand here
    if (!check) print line
    else if (held[++read] != line) complain(line)
}
function complain(line) {
    if (!bad[file]++) print file ":" (first + read - 1) ": not as sim/bundles.sh has it: " line
}
function close_list() { # nothing else stands behind what had to
    if (pending) tell()
    if (check && read < n_held) complain("nothing")
    read = n_held = 0
}
FILENAME ~ /machine\.def$/ {
    if ($1 == "const") number[$2] = $3
    next
}
FILENAME ~ /bundles\.def$/ {
    if ($1 == "bundle") name = toupper($2)
    if ($1 != "field") next
    width = $3
    if (match(width, /[A-Z]+_BITS/) && substr(width, RSTART, RLENGTH) in number)
        sub(/[A-Z]+_BITS/, number[substr(width, RSTART, RLENGTH)], width)
    if (split(width, factor, "*") == 2 && width ~ /^[0-9]+\*[0-9]+$/) width = factor[1] * factor[2]
    fields[name] = fields[name] " " $2 (width == 1 ? "" : "[" width "]")
    next
}
FNR == 1 { file = FILENAME; ports = 0 }
/^ *\/\/: / { # told anew
    if (!n_held++) first = FNR
    held[n_held] = $0
    next
}
/^module .*[^#] ?\($/ || /^\) \($/ { ports = 1; split("", told) }
/^\);/ { close_list(); ports = 0 }
{
    bundle = ""
    if (ports && match($0, /^    (input|output) .*`RT_[A-Z_]+_BITS/)) {
        bundle = substr($0, RSTART, RLENGTH - 5)
        sub(/.*`RT_/, "", bundle)
        if (!(bundle in fields)) bundle = ""
    }
    if (pending != bundle || n_held) close_list()
    if (bundle && !(bundle in told)) {
        pending = bundle
        told[bundle] = 1
    }
    if (!check) print
}
