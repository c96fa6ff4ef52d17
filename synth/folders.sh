# folders.sh - what Yosys is told of a source folder and of parameters; sourced
# SPDX-License-Identifier: Apache-2.0
#
# Of the folder $rtl: $include and $library name all folders below it that have Verilog. Of "$@",
# words PARAMETER=VALUE: $set_all has them as chparam takes them.
set_all=
for p; do set_all="$set_all -set ${p%%=*} ${p#*=}"; done
include='' library=''
for d in $(find "$rtl" -name '*.v*' -exec dirname {} + | sort -u); do
    include="$include -I$d" library="$library -libdir $d"
done
