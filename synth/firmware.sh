#!/bin/sh
# firmware.sh - compiles lab/litex/firmware.c with the driver and links it for a LiteX system
# SPDX-License-Identifier: Apache-2.0
#
# usage: synth/firmware.sh LITEX FOLDER PLACE
#   LITEX   folder of LiteX's Python package: its start-up code, headers and linker scripts are used
#   FOLDER  of the system, which has software/include; gets firmware.elf and firmware.bin
#   PLACE   rom, or ram: the SDRAM, where LiteX's own loader puts it
# Exit code 3: compiled, and the linker is absent.
set -eu
cd "$(dirname "$0")/.."
litex=$1 out=$2
case $3 in rom) script=bios ;; ram) script=demo ;; *) exit 2 ;; esac
cpu=$litex/soc/cores/cpu/vexriscv
compile() { # SOURCE OBJECT OPTION...
    source=$1 object=$2
    shift 2
    clang --target=riscv32 -march=rv32im -mabi=ilp32 -Os "$@" -c "$source" -o "$out/$object"
}
warnings='-std=gnu99 -ffreestanding -fno-builtin -Wall -Wextra -Werror'
compile "$cpu/crt0.S" crt0.o
# shellcheck disable=SC2086  # lists of words on purpose
compile lab/litex/firmware.c firmware.o $warnings -isystem "$out/software/include" \
    -isystem "$litex/soc/software/include" -isystem "$cpu"
# shellcheck disable=SC2086
compile driver/sphaera.c driver.o $warnings
ld=$(command -v riscv64-unknown-elf-ld) || exit 3
"$ld" -m elf32lriscv -L"$out/software/include" \
    -T "$litex/soc/software/$script/linker.ld" "$out/crt0.o" "$out/firmware.o" "$out/driver.o" \
    -o "$out/firmware.elf"
riscv64-unknown-elf-objcopy -O binary "$out/firmware.elf" "$out/firmware.bin"
