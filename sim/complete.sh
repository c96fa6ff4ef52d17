#!/bin/sh
# complete.sh - completion of the tool for bash or zsh, made of what --help prints
# SPDX-License-Identifier: Apache-2.0
#
# usage: SPHAERA=TOOL sim/complete.sh bash|zsh
# Commands and options come from the tables that the tool itself parses with; a word that is no
# option is completed as a file, and so is the value of one.
set -eu
commands=$("$SPHAERA" --help |
    sed -n '/^Commands:/,/^$/s/^  \([a-z]*\)  *\(.*\)/\1:\2/p')
options() { # command: --name or --name= a line
    "$SPHAERA" "$1" --help |
        sed -n 's/^ \{1,6\}\(-[A-Za-z?], \)\{0,1\}\(--[a-z-]*\)\(\[*=\)*.*/\2\3/p' |
        sed 's/\[=/=/' | sort -u
}
case $1 in
bash)
    echo "# completion of sphaera for bash, made of its tables of options"
    echo "_sphaera() {"
    echo "    local word=\${COMP_WORDS[COMP_CWORD]} words"
    echo "    if [ \"\$COMP_CWORD\" -eq 1 ]; then"
    echo "        words='$(echo "$commands" | sed 's/:.*//' | tr '\n' ' ')--help --version'"
    echo "    else"
    echo "        case \${COMP_WORDS[1]} in"
    for command in $(echo "$commands" | sed 's/:.*//'); do
        echo "        $command) words='$(options "$command" | tr '\n' ' ')' ;;"
    done
    cat <<'END'
        esac
    fi
    case $word in
    -*) ;;
    *) [ "$COMP_CWORD" -eq 1 ] || words= ;;
    esac
    compopt +o nospace 2>/dev/null
    if [ -n "$words" ]; then
        COMPREPLY=($(compgen -W "$words" -- "$word"))
        case ${COMPREPLY[0]} in *=) compopt -o nospace 2>/dev/null ;; esac
    else
        COMPREPLY=($(compgen -f -- "$word"))
    fi
}
complete -o filenames -F _sphaera sphaera
END
    ;;
zsh)
    echo "#compdef sphaera"
    echo "# completion of sphaera for zsh, made of its tables of options"
    echo "local -a commands options"
    echo "commands=("
    echo "$commands" | sed "s/'/'\\\\''/g; s/.*/    '&'/"
    echo ")"
    echo "if (( CURRENT == 2 )); then"
    echo "    _describe 'command' commands"
    echo "    return"
    echo "fi"
    echo "case \$words[2] in"
    for command in $(echo "$commands" | sed 's/:.*//'); do
        echo "    $command) options=($(options "$command" | sed "s/.*/'&'/" | tr '\n' ' ')) ;;"
    done
    cat <<'END'
esac
if [[ $PREFIX == -* ]]; then
    compadd -S '' -- ${(M)options:#*=}
    compadd -- ${options:#*=}
else
    _files
fi
END
    ;;
*)
    echo "usage: SPHAERA=TOOL sim/complete.sh bash|zsh" >&2
    exit 2
    ;;
esac
