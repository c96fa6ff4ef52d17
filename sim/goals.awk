# goals.awk - goals of a command line against the targets of makefiles
# SPDX-License-Identifier: Apache-2.0
#
# After nearest.awk; reads makefiles. goals: words; one with a slash is a file, which make looks
# for itself. Says on stderr which are no target, with the nearest one; exit code 1 then.
/^\t/ { next }
{
    line = line $0
    if (sub(/\\$/, "", line)) next
    if (match(line, /^[^=#]*::?([^=]|$)/)) {
        sub(/[;#|].*/, "", line)
        names = line
        sub(/:.*/, "", names)
        if (names == ".PHONY") sub(/.*:/, "", line)
        else line = names
        n = split(line, part, " ")
        for (i = 1; i <= n; i++)
            if (part[i] ~ /^[a-z][a-z0-9_-]*$/ && !(part[i] in there)) {
                there[part[i]] = 1
                target[++n_targets] = part[i]
            }
    }
    line = ""
}
END {
    n = split(goals, part, " ")
    for (i = 1; i <= n; i++) {
        if (part[i] in there || part[i] == "FORCE" || part[i] ~ /\//) continue
        meant = nearest(part[i], target, n_targets)
        print "there is no target " part[i] (meant != "" ? "; is " meant " meant?" : ".") \
              " `make help-all` prints them" > "/dev/stderr"
        failed = 1
    }
    exit failed
}
