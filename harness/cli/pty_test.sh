#!/usr/bin/env bash
# The command on a real terminal, and in a pipe: colours, width, progress, pictures. script(1) makes the terminal. $1 is
# the command.
set -uo pipefail
fillrule=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
unset NO_COLOR CLICOLOR_FORCE COLORTERM TERM_PROGRAM TMUX
export TERM=xterm
escape=$'\033'

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}
# A case that lavapipe gets wrong. On a slow machine its run may be long enough for progress, which is not asked about.
faulty="'$fillrule' run 'interpolation/noperspective_clipped[planes=3,w=4]' 2>/dev/null --candidate lavapipe --reference none"

# on_terminal COLUMNS COMMAND: what a terminal of so many columns gets.
on_terminal() {
  script --quiet --return --echo never --command "stty cols $1 rows 40; $2" /dev/null </dev/null
}
holds() { grep -qF -- "$2" <<<"$1" || fail "$3: no '$2'"; }
lacks() { if grep -qF -- "$2" <<<"$1"; then fail "$3: '$2' is there"; fi; }

output=$(on_terminal 100 "$faulty")
holds "$output" "${escape}[1;31mFAILED" 'a terminal has colours'
holds "$output" "map of 64 x 64 pixels" 'a terminal shows the map'
lacks "$output" '▀' 'a terminal that is not known to show pictures gets none'
lacks "$(on_terminal 100 "NO_COLOR=1 $faulty")" "$escape" 'NO_COLOR'
lacks "$(on_terminal 100 "$faulty --color=never")" "$escape" '--color=never'
lacks "$(on_terminal 100 "TERM=dumb $faulty")" "$escape" 'a dumb terminal'
holds "$(on_terminal 120 "COLORTERM=truecolor $faulty")" '▀' 'a terminal with 24-bit colours shows pictures'
holds "$(on_terminal 100 "TERM=xterm-kitty $faulty")" "${escape}_Ga=T,f=24," 'kitty shows pictures'

output=$(bash -c "$faulty" 2>&1)
lacks "$output" "$escape" 'a pipe'
holds "$output" '  FAILED  interpolation/noperspective_clipped[planes=3,w=4]' 'a pipe'
holds "$(CLICOLOR_FORCE=1 bash -c "$faulty" 2>&1)" "${escape}[1;31mFAILED" 'CLICOLOR_FORCE'
lacks "$(CLICOLOR_FORCE=1 NO_COLOR=1 bash -c "$faulty" 2>&1)" "$escape" 'NO_COLOR before CLICOLOR_FORCE'
holds "$(bash -c "$faulty --color always" 2>&1)" "${escape}[1;31mFAILED" '--color always'
holds "$(bash -c "$faulty --preview blocks" 2>&1)" '▀' '--preview blocks'
holds "$(bash -c "$faulty --preview kitty" 2>&1)" "${escape}_Ga=T,f=24," '--preview kitty'
lacks "$(bash -c "$faulty --quiet" 2>&1)" 'FAILED' '--quiet'

# The width: only the commands that are there to be pasted are longer.
for columns in 40 60 100; do
  long=$(on_terminal "$columns" "$faulty --color=never" | tr -d '\r' | grep -v ' it: fillrule ' |
    awk -v columns="$columns" 'length($0) > columns')
  [ -z "$long" ] || fail "a terminal of $columns columns is overrun: $long"
done

# A run of two seconds on the fastest machine, as progress is first shown after one: it is held up when it has begun.
cat >"$work/slowly" <<'BASH'
"$@" &
for _ in 1 2 3 4; do
  kill -STOP $! 2>/dev/null || break
  sleep 0.5
  kill -CONT $!
  sleep 0.05
done
wait $!
BASH
cat >"$work/long.toml" <<'TOML'
title = "long"
why = "takes long enough to show how far it is"
spec = "none"
[target]
size = [512, 512]
[sweep]
x = { from = 1, to = 60, step = 1 }
y = { from = 1, to = 4, step = 1 }
[[draw]]
space = "framebuffer"
positions = [[0, 0], ["500 + x", 0], [0, "511 + y"]]
TOML
long="bash '$work/slowly' '$fillrule' run '$work/long.toml' --reference none --jobs 1"
output=$(on_terminal 100 "$long")
holds "$output" 'of 240 cases, ' 'progress'
holds "$output" ' left' 'progress'
holds "$output" $'\r'"$(printf '%99s' '')"$'\r' 'progress is taken away'
lacks "$(on_terminal 100 "TERM=dumb $long")" "$escape" 'progress on a dumb terminal'
lacks "$(on_terminal 100 "$long 2>'$work/stderr'")" ' left' 'progress is on stderr alone'
[ ! -s "$work/stderr" ] || fail 'progress in a file'
lacks "$(on_terminal 100 "$long --quiet")" ' left' 'progress with --quiet'

if [ "$failures" -eq 0 ]; then echo 'all terminal checks passed'; fi
exit "$((failures > 0))"
