# check.awk - values in the environment against the rules of make/variables.mk; see check.sh
# SPDX-License-Identifier: Apache-2.0
#
# names: variables to check. given: names that the command line has. goals: what is made.
# After nearest.awk and rules.awk. Exit code 1 if anything is wrong.
function wrong(text) {
    print text > "/dev/stderr"
    failed = 1
}
function quoted(text) { # for the shell
    gsub(/'/, "'\\''", text)
    return "'" text "'"
}
function says(script, value, line) { # what a script says against a value, "" if nothing
    line = ""
    script = "sh sim/" script " " quoted(value) " 2>&1 >/dev/null"
    while ((script | getline line) > 0) reason = reason (reason != "" ? "\n" : "") line
    return close(script) != 0
}
function window_fits(value, side, at, size) {
    if (value !~ /^[0-9]+,[0-9]+,[0-9]+,[0-9]+$/) {
        reason = "is no window such as 0,0,16,9: left, top, right and bottom, the last two outside"
        return 0
    }
    split(value, at, ",")
    if (at[1] + 0 >= at[3] + 0 || at[2] + 0 >= at[4] + 0) reason = "has no pixel"
    size = ENVIRON["SIZE"]
    if (size ~ /^[0-9]+x[0-9]+$/ && split(size, side, "x") &&
        (at[3] + 0 > side[1] + 0 || at[4] + 0 > side[2] + 0))
        reason = "is not inside SIZE=" size
    return reason == ""
}
function pixel_fits(value, side, at, size) {
    if (value !~ /^[0-9]+,[0-9]+$/) {
        reason = "is no pixel such as 21,9"
        return 0
    }
    size = ENVIRON["SIZE"]
    if (size ~ /^[0-9]+x[0-9]+$/ && ENVIRON["SAMPLES"] <= 1 && split(size, side, "x") &&
        split(value, at, ",") && (at[1] + 0 >= side[1] + 0 || at[2] + 0 >= side[2] + 0))
        reason = "is not inside SIZE=" size
    return reason == ""
}
function size_fits(value, side) {
    if (value ~ /^[0-9]+x[0-9]+$/ && split(value, side, "x") && side[1] >= 1 && side[2] >= 1 &&
        side[1] + 0 <= constant["MAX_SIDE"] && side[2] + 0 <= constant["MAX_SIDE"])
        return 1
    reason = "is no size such as 640x360, up to " constant["MAX_SIDE"] "x" constant["MAX_SIDE"]
    return 0
}
function error_fits(value, part) {
    split(value, part, ",")
    if (value ~ /^[0-9]*[.]?[0-9]+(,[0-9]*[.]?[0-9]+)?$/ && part[1] >= 1e-9 && part[1] <= 1e9 &&
        part[2] <= 99)
        return 1
    reason = "is no error such as 0.125 or 0.125,45: pixels, and dB up to 99"
    return 0
}
function plain(value, blanks) { # nothing in it means anything to make or a shell
    if (!blanks && value ~ /[ \t]/) reason = "has a blank"
    else if (match(value, /['"`\\;&|<>(){}*?!#]/) || match(value, /\[|\]/) || match(value, /^~/))
        reason = "has a " substr(value, RSTART, 1)
    if (reason != "" && value ~ /\//) reason = reason "; a link to it may have a plain name"
    return reason == ""
}
# A rule without words that belong to goals that are not made.
function for_goals(rule, alternative, n, i, goal, text) {
    n = split(rule, alternative, "|")
    for (i = 1; i <= n; i++) {
        goal = alternative[i]
        if (!sub(/.*@/, "", goal) || index(" " goals " ", " " goal " ")) {
            sub(/@.*/, "", alternative[i])
            text = text (i > 1 ? "|" : "") alternative[i]
        }
    }
    return text
}
# Whether one alternative takes the value; may leave a reason.
function fits(rule, value, ends) {
    if (rule == value && rule !~ /^</) return 1
    if (rule ~ /\.\./) {
        split(rule, ends, /\.\./)
        ends[2] = bound(ends[2])
        return value ~ /^[0-9]+$/ && length(value) <= 15 && value + 0 >= ends[1] + 0 &&
               (ends[2] < 0 || value + 0 <= ends[2])
    }
    if (value == "") return 0
    if (rule == "<text>") return 1
    if (rule == "<word>" || rule == "<words>") return plain(value, rule == "<words>")
    if (rule == "<size>") return size_fits(value)
    if (rule == "<error>") return error_fits(value)
    if (rule == "<window>") return window_fits(value)
    if (rule == "<pixel>") return pixel_fits(value)
    if (rule == "<profile>") return !says("profile.sh", value)
    if (rule == "<effects>") return !says("parameters.sh", value)
    if (rule == "<sizes>") return !says("sizes.sh", value)
    if (rule == "<scene>") return !says("scene.sh", value)
    return 0
}
function check(name, rule, alternative, n, i, value, text, meant) {
    value = ENVIRON[name]
    reason = ""
    n = split(for_goals(rule), alternative, "|")
    if (value == "" && rule ~ /\|$/) return
    for (i = 1; i <= n; i++) if (fits(alternative[i], value)) return
    text = spoken(for_goals(rule))
    meant = nearest(value, choice, n_choices)
    if (value == "") reason = "is empty" (text != "" ? "; there is " text : "")
    else if (reason == "") reason = (text ~ /,/ ? "is none of " : "is not ") text
    else if (text != "") reason = reason "; nor is it " text
    wrong(name "=" value ": " reason (meant != "" ? "; is " meant " meant?" : ""))
}
END {
    n = split(given, part, " ")
    for (i = 1; i <= n; i++) if (!(part[i] in rule_of)) {
        meant = nearest(part[i], known, n_known)
        wrong("there is no variable " part[i] (meant != "" ? "; is " meant " meant?" : ""))
        unknown = 1
    }
    if (unknown) {
        line = "There are"
        for (i = 1; i <= n_known; i++) {
            if (length(line known[i]) > 98) {
                wrong(line)
                line = " "
            }
            line = line " " known[i]
        }
        wrong(line)
    }
    n = split(names, part, " ")
    for (i = 1; i <= n; i++) check(part[i], rule_of[part[i]])
    exit failed
}
