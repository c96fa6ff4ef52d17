# splice.awk - replaces what stands in a page between a line <!-- MARK --> and the next <!-- end -->
# SPDX-License-Identifier: Apache-2.0
#
# usage: awk -v mark=MARK -v text=FILE -f tests/hard/splice.awk PAGE
!inside
$0 == "<!-- end -->" && inside { inside = 0; print }
$0 == "<!-- " mark " -->" {
    inside = 1
    while ((getline line <text) > 0) print line
}
