#!/bin/bash
# Presses real keys in a real window, on a screen of its own (Xvfb), and looks at what the program
# says and saves. Usage: keys_test.sh LUCH SCENE. Exit status 77: skipped.
set -u
luch=$1 scene=$2
for tool in Xvfb xdotool; do
    command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

folder=$(mktemp -d)
exec 3<>"$folder/number"
Xvfb -displayfd 3 -screen 0 800x600x24 >"$folder/xvfb.txt" 2>&1 &
xvfb=$!
viewer=
finish() {
    [ -n "$viewer" ] && kill -9 "$viewer" 2>/dev/null
    kill "$xvfb" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$folder"
}
trap finish EXIT
fail() {
    echo "failed: $1"
    cat "$folder/out.txt" "$folder/err.txt" 2>/dev/null
    exit 1
}
# until_so WHAT COMMAND…: asks every tenth of a second for a minute.
until_so() {
    local what=$1
    shift
    for _ in $(seq 600); do
        "$@" >/dev/null 2>&1 && return
        sleep 0.1
    done
    fail "$what"
}
# insist WHAT KEY COMMAND…: presses a key until the command succeeds: a key that is pressed while the
# window is still being mapped reaches nobody.
insist() {
    local what=$1 key=$2 turn
    shift 2
    for turn in $(seq 600); do
        [ $((turn % 30)) = 1 ] && xdotool key "$key"
        "$@" >/dev/null 2>&1 && return
        sleep 0.1
    done
    fail "$what"
}
said() { grep -q -- "$1" "$folder/out.txt"; }
saved() { grep -c "^saved " "$folder/out.txt"; }
more_saved_than() { [ "$(saved)" -gt "$1" ]; }
ended() { ! kill -0 "$viewer"; }
start() {
    (cd "$folder" && exec "$luch" view "$scene" "$@" >out.txt 2>err.txt) &
    viewer=$!
    until_so "no window opens" xdotool search --onlyvisible --name "luch view"
    xdotool mousemove 400 300
}
quit_with_escape() {
    insist "Escape does not quit" Escape ended
    wait "$viewer"
    local status=$?
    viewer=
    [ $status = 0 ] || fail "Escape: exit status $status"
}
# F12 saves a picture; `camera` is then what it shows.
take_picture() {
    insist "F12 saves no picture" F12 more_saved_than "$(saved)"
    local last
    last=$(grep "^saved " "$folder/out.txt" | tail -n 1)
    [ -s "$folder/$(sed 's/^saved //; s/;.*//' <<<"$last")" ] || fail "the picture is empty: $last"
    camera=$(sed -n 's/.*--camera //p' <<<"$last")
}
# The frame is made in the background, so that the picture may be late.
until_camera() {
    for _ in $(seq 100); do
        take_picture
        [ "$camera" $2 "$3" ] && return
        sleep 0.2
    done
    fail "$1"
}

until_so "Xvfb does not start" [ -s "$folder/number" ]
read -r number <"$folder/number"
export DISPLAY=:$number

start --size 160x120
until_camera "no frame is made" != ""
first=$camera
xdotool key Up
until_camera "Up does not move the camera" != "$first"
moved=$camera
xdotool mousemove 390 290 mousedown 1 mousemove 410 300 mouseup 1
until_camera "dragging does not turn the camera" != "$moved"
xdotool key Home
until_camera "Home does not lead back" = "$first"
insist "F5 times nothing" F5 said "timed: baseline"
xdotool key Tab c F1 p
take_picture
quit_with_escape

# A frame that takes minutes does not hold the window.
start --size 640x480 --spp 10000
quit_with_escape
echo "keys, mouse, pictures, timing and Escape work"
