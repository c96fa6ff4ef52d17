# words.py - what somebody may have meant, and how a program of sim/ says that a word is wrong
# SPDX-License-Identifier: Apache-2.0


class Wrong(Exception):
    """With what is said of it; code: of the exit."""

    def __init__(self, text, code=1):
        super().__init__(text)
        self.code = code


def edits(a, b):
    """Letters put in, left out, replaced or swapped."""
    above, row = [], list(range(len(b) + 1))
    for i, letter in enumerate(a):
        before, above, row = above, row, [i + 1]
        for j, other in enumerate(b):
            best = min(above[j] + (letter != other), above[j + 1] + 1, row[j] + 1)
            if i and j and letter == b[j - 1] and a[i - 1] == other:
                best = min(best, before[j - 1] + (letter != other))
            row.append(best)
    return row[-1]


def nearest(word, words):
    """The one of them with the fewest edits, whether large or small; "" if these are more than one
    and more than a third of the word, or half of both words. Of a name with folders the last part
    alone may match."""
    found, least = "", len(word)
    for other in words:
        for text, more in (other, 0), (other.rpartition("/")[2], 0.5):
            e = edits(word.lower(), text.lower())
            if e <= max(1, len(word) / 3) and 2 * e < max(len(word), len(text)) \
                    and e + more < least:
                found, least = other, e + more
    return found


def perhaps(word, words, end=""):
    """"; is X meant?", or the end of the sentence."""
    meant = nearest(word, words)
    return f"; is {meant} meant?" if meant else end


def lines(first, words):
    """A list of words behind a sentence, in lines of 98 columns."""
    text, line = [], first
    for word in words:
        if len(line) + len(word) > 98:
            text.append(line)
            line = " "
        line += " " + word
    return "\n".join([*text, line])
