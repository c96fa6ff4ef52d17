# nearest.awk - the word of a list that somebody may have meant
# SPDX-License-Identifier: Apache-2.0
#
# nearest(WORD, LIST, N): of LIST[1..N] the one with the fewest letters put in, left out, replaced
# or swapped, whether large or small; "" if it is more than a third of the word and one. Of a name
# with folders the last part alone may match.
function edits(a, b, i, j, d, cost, best) {
    for (i = 0; i <= length(a); i++) d[i, 0] = i
    for (j = 0; j <= length(b); j++) d[0, j] = j
    for (i = 1; i <= length(a); i++)
        for (j = 1; j <= length(b); j++) {
            cost = substr(a, i, 1) != substr(b, j, 1)
            best = d[i - 1, j - 1] + cost
            if (d[i - 1, j] + 1 < best) best = d[i - 1, j] + 1
            if (d[i, j - 1] + 1 < best) best = d[i, j - 1] + 1
            if (i > 1 && j > 1 && substr(a, i, 1) == substr(b, j - 1, 1) &&
                substr(a, i - 1, 1) == substr(b, j, 1) && d[i - 2, j - 2] + cost < best)
                best = d[i - 2, j - 2] + cost
            d[i, j] = best
        }
    return d[length(a), length(b)]
}
function nearest(word, list, n, i, tail, e, found, least) {
    least = length(word) / 3 + 1.5
    for (i = 1; i <= n; i++) {
        tail = list[i]
        sub(/.*\//, "", tail)
        e = edits(tolower(word), tolower(list[i]))
        if (edits(tolower(word), tolower(tail)) < e) e = edits(tolower(word), tolower(tail)) + 0.5
        if (e < least || (e == least && !found)) {
            least = e
            found = list[i]
        }
    }
    return found
}
