#!/usr/bin/env bash
# build_kit.sh LUCH DIR: writes the students' kit into DIR, anew, and builds it by the commands of its
# README.md. What this tree compiled is found again by ccache.
set -eu
luch=$1 dir=$2

rm -rf "$dir"
"$luch" kit "$dir"
cd "$dir"
commands=$(sed -n 's/^    \(cmake .*\)$/\1/p' README.md)
[ "$(wc -l <<<"$commands")" = 2 ] || { echo "README.md has not the two commands: $commands"; exit 1; }
while IFS= read -r command; do
    echo "+ $command"
    bash -c "$command" </dev/null
done <<<"$commands"
