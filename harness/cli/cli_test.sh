#!/usr/bin/env bash
# The command as a user meets it: exit codes, outputs, files outside the repository. $1 is the command.
set -uo pipefail
fillrule=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# expect CODE TEXT COMMAND...: the exit code, and a text that the output must hold ('' for none).
expect() {
  local code=$1 text=$2 output status
  shift 2
  output=$("$@" 2>&1)
  status=$?
  if [ "$status" -ne "$code" ] || ! grep -qF -- "$text" <<<"$output"; then
    printf 'FAILED: %s\n  exit code %s, expected %s with the text: %s\n%s\n' "$*" "$status" "$code" "$text" "$output"
    failures=$((failures + 1))
  fi
}

# expect_file FILE TEXT
expect_file() {
  grep -qF -- "$2" "$1" 2>/dev/null || { echo "FAILED: no '$2' in $1"; failures=$((failures + 1)); }
}

head='title = "t"
why = "w"
spec = "s"
[target]
size = [16, 16]'
mkdir "$work/own"
printf '%s\n[[draw]]\nspace = "framebuffer"\npositions = [[1, 1], [15, 1], [1, 15]]\n' "$head" >"$work/own/good.toml"
printf '%s\n[[draw]]\ncolour = 3\npositions = []\n' "$head" >"$work/own/bad.toml"

cd "$work" || exit 1
expect 0 'coverage/shared_diagonal' "$fillrule" list 'coverage/shared_*'
expect 0 '1 case: 1 passed' "$fillrule" run own/good.toml
expect 0 '1 case: 1 passed' "$fillrule" run "$work/own/good.toml" --reference none
expect 2 'own/bad.toml:7:1' "$fillrule" run own
expect 2 '1 case: 1 passed' "$fillrule" run own
expect 2 '2 errors in case files or selectors' "$fillrule" run own
expect 2 'no_such_case' "$fillrule" run coverage/no_such_case
expect 2 '1 error in case files or selectors' "$fillrule" run coverage/no_such_case
if "$fillrule" run 'coverage/no_such_*' --timing 2>/dev/null | grep .; then
  echo 'FAILED: a run without cases prints a table'
  failures=$((failures + 1))
fi
expect 2 'Run with --help' "$fillrule" run --no-such-option
expect 2 'subcommand' "$fillrule"
expect 2 'there is no command "rnu"' "$fillrule" rnu own/good.toml
expect 2 'did you mean "run"?' "$fillrule" rnu own/good.toml
expect 2 "there is no candidate 'painter'" "$fillrule" run own/good.toml --candidate painter
expect 3 "no Vulkan device of the driver 'voodoo'" "$fillrule" run own/good.toml --reference voodoo
expect 3 'lavapipe' "$fillrule" run own/good.toml --reference voodoo
# Cases for half a minute, of which there is always one under way. Sanitizers would report a crash themselves unless
# told not to.
cat >own/slow.toml <<TOML
${head/16, 16/512, 512}
[sweep]
x = { from = 1, to = 100, step = 1 }
y = { from = 1, to = 100, step = 1 }
[[draw]]
space = "framebuffer"
positions = [[0, 0], ["400 + x", 0], [0, "400 + y"]]
TOML
expect_crash() {
  expect 139 "$1" env ASAN_OPTIONS=handle_segv=0 TSAN_OPTIONS=handle_segv=0 \
    bash -c '(sleep 2; kill -SEGV $$) & exec "$0" run own/slow.toml --reference none --jobs 1' "$fillrule"
}
expect_crash 'fillrule: died of signal SIGSEGV; the innermost frames first:'
expect_crash 'fillrule: under way: drawn or judged for the candidate renderer: slow[x='
rm own/slow.toml
expect 0 'lavapipe' "$fillrule" devices
expect 0 'own/cases/topic/a_case.toml' "$fillrule" new topic/a_case --folder own/cases
expect 2 'is there already' "$fillrule" new topic/a_case --folder own/cases
expect 2 '"a_case" is no name for a case' "$fillrule" new a_case --folder own/cases
expect 0 '3 passed' "$fillrule" run topic/a_case --suite own/cases --reference oracle
expect 2 "title is still the template's" "$fillrule" check own/cases/topic/a_case.toml
expect 2 '1 file, 3 findings' "$fillrule" check 'topic/a_case[shift=1]' --suite own/cases
expect 0 '2 files, 0 findings' "$fillrule" check coverage/shared_diagonal coverage/last_pixel
expect 0 'gl_PointCoord' "$fillrule" features
expect 0 'Exit codes' "$fillrule" run --help
# An image of a scene that is missing, and one that is none: nobody is to blame, and the other cases go on.
mkdir scenes
scene() { printf '%s\n[scene]\n[[scene.object]]\nmesh = "cube"\nmaterial = { texture = "%s" }\n' "$head" "$1"; }
scene grid.png >scenes/good.toml
scene none.png >scenes/missing.toml
scene torn.png >scenes/torn.toml
echo 'no image' >scenes/torn.png
expect 2 'scenes/missing.toml:9:24: there is no image "none.png"' "$fillrule" run scenes
expect 2 'scenes/torn.png: cannot be read as an image' "$fillrule" run scenes
expect 2 '2 cases: 1 passed, 0 failed, 1 skipped' "$fillrule" run scenes --reference none
cp own/good.toml bare.toml
expect 0 'PASSED  bare' "$fillrule" run bare.toml -v
expect 0 'bare.png' "$fillrule" show bare.toml --report "$work/shown"
expect 0 '1 passed' "$fillrule" run --profile top_left,precise own/good.toml
expect 0 'against the oracle alone' "$fillrule" run own/good.toml --reference oracle
expect 0 'candidate lavapipe' "$fillrule" run own/good.toml --candidate lavapipe --reference none
expect 0 'lavapipe and lavapipe draw differently, as permitted, 0 samples' "$fillrule" run own/good.toml --reference lavapipe,lavapipe
mkdir expected
printf '[[deviation]]\ncases = ["good"]\nplanes = ["owner"]\nreason = "r"\nsource = "s"\n' >expected/lavapipe-22.3.6.toml
expect 0 'GONE from lavapipe: good (owner)' "$fillrule" run own/good.toml --expected expected
expect 1 'GONE from lavapipe: good (owner)' "$fillrule" run own/good.toml --expected expected --strict-reference
expect 0 'times the reference alone' "$fillrule" run own/good.toml --timing
expect 0 'good.png' "$fillrule" show own/good.toml --report "$work/shown"
[ -s "$work/shown/good.png" ] && [ -s "$work/shown/good.reference.exr" ] || { echo 'FAILED: no pictures'; failures=$((failures + 1)); }

expect 0 '' "$fillrule" run own/good.toml --json "$work/results.json" --report "$work/report"
expect_file "$work/results.json" '"driver": "lavapipe"'
expect_file "$work/report/results.json" '"candidate_faults": 0'
expect 2 'cannot be written' "$fillrule" run own/good.toml --json "$work/no/such/folder.json"


# A place that cannot be written to is refused before anything is drawn: no case is counted.
expect_nothing_run() {
  expect 2 'cannot be' "$@"
  if grep -qE 'passed|PASSED|triangles a second' <<<"$("$@" 2>&1)"; then
    echo "FAILED: $* runs before it refuses"
    failures=$((failures + 1))
  fi
}
expect_nothing_run "$fillrule" run own/good.toml --report /dev/null/report
expect_nothing_run "$fillrule" run own/good.toml --json "$work/no/such/folder.json"
expect_nothing_run "$fillrule" show own/good.toml --report /dev/null/shown
expect_nothing_run "$fillrule" stress --triangles 100 --reference none --out /dev/null/stress
[ ! -e no ] || { echo 'FAILED: a folder is left behind'; failures=$((failures + 1)); }

# A driver that is at fault, judged as the candidate: the commands that a failing case ends with can be pasted.
expect 1 'see it: fillrule show ' "$fillrule" run 'interpolation/noperspective_clipped[planes=3,w=4]' --candidate lavapipe --reference none
follow() {
  local command
  command=$("${@:2}" 2>&1 | sed -n "s/^    $1 it: fillrule //p" | head -n 1)
  expect 0 'must cover the sample' bash -c "'$fillrule' $command"
}
follow explain "$fillrule" run 'interpolation/noperspective_clipped[planes=3,w=4]' --candidate lavapipe --reference none
follow explain "$fillrule" stress --triangles 400 --families mixed_w --expected none --out "$work/stress"

# A candidate that is held to lavapipe's subpixel bits, and snaps to another grid, is caught and shown.
printf '%s\n[[draw]]\nspace = "framebuffer"\npositions = [[1, 1], ["10.5 + 1/64", 1], ["10.5 + 1/64", 15]]\n' "$head" >"$work/own/good.toml"
expect 0 '1 passed' "$fillrule" run own/good.toml --subpixel-bits 4

# Classic faults, made on purpose.
expect 0 'affine_varyings: smooth varyings' "$fillrule" faults --list
expect 2 'did you mean "line_ties"?' "$fillrule" faults line_tie
expect 2 'did you mean "line_ties"?' "$fillrule" run own/good.toml --candidate faults:line_tie
expect 1 'FAILED  good' "$fillrule" run own/good.toml --candidate faults:pixel_corners --reference none
expect 0 '1 passed' "$fillrule" run own/good.toml --candidate faults:none --reference none
mkdir one && cp own/good.toml one/
expect 1 'NOT CAUGHT pixel_corners     1 cases' "$fillrule" faults pixel_corners --suite one --json faults.json --markdown faults.md
expect_file faults.json '"caught_by": 1'
expect_file faults.md '| `pixel_corners` |'

# The small world.
expect 0 'lavapipe: equal to the oracle on all triangles' "$fillrule" exhaust --grid 2 --size 2
expect 2 'a grid of 1/3 px' "$fillrule" exhaust --grid 3
expect 2 'cells of 5 x 5 px' "$fillrule" exhaust --size 5
expect 2 "there is no candidate 'painter'" "$fillrule" exhaust --candidate painter
expect 3 "no Vulkan device of the driver 'voodoo'" "$fillrule" exhaust --reference voodoo

# Scenes in colour.
expect 0 "$work/cube.png" "$fillrule" render scenes/textured_cube -o "$work/cube.png"
expect 0 "$work/driver.exr" "$fillrule" render scenes/textured_cube -o "$work/driver.exr" --by lavapipe --size 64x32
expect 0 "$work/turn_002.png" "$fillrule" render scenes/textured_cube -o "$work/turn.png" --turntable 3 --size 32x32
[ -s "$work/cube.png" ] && [ -s "$work/driver.exr" ] && [ -s "$work/turn_000.png" ] ||
  { echo 'FAILED: no renderings'; failures=$((failures + 1)); }
if cmp -s "$work/turn_000.png" "$work/turn_001.png"; then echo 'FAILED: the table does not turn'; failures=$((failures + 1)); fi
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$work/own/model.obj"
expect 0 "$work/model.png" "$fillrule" render own/model.obj -o "$work/model.png"
printf 'v 0 0 0\nf 1 2 3\n' >"$work/own/broken.obj"
expect 2 'broken.obj:2:5: 2 in "2" names no "v"' "$fillrule" render own/broken.obj -o "$work/model.png"
printf '%s\n[[scene.object]]\nmesh = "cubw"\n' "$head" >"$work/own/scene.toml"
expect 2 'did you mean "cube"' "$fillrule" run own/scene.toml
printf '%s\n[[scene.object]]\nmesh = "cube"\n' "$head" >"$work/own/scene.toml"
expect 0 '1 passed' "$fillrule" run own/scene.toml
rm own/scene.toml own/model.obj own/broken.obj
expect 2 'is no scene' "$fillrule" render 'coverage/shared_diagonal[diagonal=0,shift_x=0]' -o "$work/a.png"
expect 2 'cases match' "$fillrule" render scenes/mipmaps -o "$work/a.png"
expect 2 'neither .png nor .exr' "$fillrule" render scenes/textured_cube -o "$work/a.jpg"
expect 2 'WIDTHxHEIGHT' "$fillrule" render scenes/textured_cube -o "$work/a.png" --size 64
expect 3 "no Vulkan device of the driver 'voodoo'" "$fillrule" render scenes/textured_cube -o "$work/a.png" --by voodoo

# One sample, and random triangles.
expect 0 'The sample lies' "$fillrule" explain own/good.toml --pixel 4,4
expect 2 'pixel 99,4 is not in the target of 16 x 16 pixels' "$fillrule" explain own/good.toml --pixel 99,4
expect 2 "--pixel takes X,Y" "$fillrule" explain own/good.toml --pixel 4
expect 2 'sample 4 is not in a target of 1 sample per pixel' "$fillrule" explain own/good.toml --pixel 4,4 --sample 4
expect 2 '--sample: not a whole number from 0' "$fillrule" explain own/good.toml --pixel 4,4 --sample -1
expect 2 '--seed: not a whole number from 0' "$fillrule" stress --seed -1 --triangles 16
expect 2 '--triangles: not a whole number from 1' "$fillrule" stress --triangles -1
expect 2 '--triangles: not a whole number from 1' "$fillrule" stress --triangles 0
expect 2 '--grid: not a whole number from 1' "$fillrule" exhaust --grid -4
expect 2 '4 cases match' "$fillrule" explain coverage/shared_diagonal --pixel 4,4
expect 0 'triangles a second' "$fillrule" stress --triangles 500 --reference none --out "$work/stress"
expect 2 'medium' "$fillrule" stress --families medium --out "$work/stress"

if [ "$failures" -eq 0 ]; then echo 'all command line checks passed'; fi
exit "$((failures > 0))"
