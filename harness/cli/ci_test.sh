#!/usr/bin/env bash
# What CI systems meet: shards and their merge, JUnit, annotations, and names that nobody would choose. $1 is the command.
set -uo pipefail
fillrule=$(realpath "$1")
schema=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../ci_systems/junit.xsd")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0
unset GTEST_TOTAL_SHARDS GTEST_SHARD_INDEX GITHUB_STEP_SUMMARY GITHUB_WORKSPACE CI_PROJECT_DIR

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}
# expect CODE TEXT COMMAND...: the exit code, and a text that the output must hold ('' for none).
expect() {
  local code=$1 text=$2 output status
  shift 2
  output=$("$@" 2>&1)
  status=$?
  if [ "$status" -ne "$code" ] || ! grep -qF -- "$text" <<<"$output"; then
    fail "$* (exit code $status, expected $code with the text: $text)"$'\n'"$output"
  fi
}
valid() { xmllint --noout --schema "$schema" "$1" 2>errors || fail "$1: $(cat errors)"; }
# The results without what time there was.
timeless() { python3 - "$1" <<'PYTHON'
import json, sys
def strip(value):
    if isinstance(value, dict):
        return {key: strip(one) for key, one in value.items() if not key.endswith("seconds")}
    return [strip(one) for one in value] if isinstance(value, list) else value
print(json.dumps(strip(json.load(open(sys.argv[1]))), indent=1))
PYTHON
}

# Faults of the candidate, known ones and none at all: lavapipe judged, and lavapipe as the reference.
cases=('interpolation/noperspective_clipped*' 'coverage/shared_*')
for parties in '--candidate lavapipe --reference none' '--reference lavapipe'; do
  rm -rf whole shards merged
  # shellcheck disable=SC2086 # several words
  "$fillrule" run "${cases[@]}" $parties --report whole --junit whole/junit.xml >/dev/null 2>&1
  code=$?
  for i in 1 2 3; do
    # shellcheck disable=SC2086
    "$fillrule" run "${cases[@]}" $parties --shard $i/3 --report shards/$i >/dev/null 2>&1
  done
  expect "$code" 'merged 3 reports into merged' "$fillrule" merge shards/2 shards/3 shards/1 -o merged --junit merged/junit.xml
  diff <(timeless whole/results.json) <(timeless merged/results.json) >difference || fail "$parties: the merged results differ: $(head -n 20 difference)"
  diff <(sed -E 's/ time="[^"]*"//g; s#whole/#R/#g' whole/junit.xml) <(sed -E 's/ time="[^"]*"//g; s#merged/#R/#g' merged/junit.xml) >difference ||
    fail "$parties: the merged JUnit differs: $(head -n 20 difference)"
  [ "$(cd whole && ls)" = "$(cd merged && ls)" ] || fail "$parties: other files are merged"
  valid whole/junit.xml
done

# The last merge's shards, and what must not be merged.
expect 2 'shard 2 of 3 is missing' "$fillrule" merge shards/1 shards/3 -o refused
expect 2 'a second time' "$fillrule" merge shards/1 shards/1 shards/2 -o refused
expect 2 'nowhere/results.json: cannot be read' "$fillrule" merge nowhere -o refused
"$fillrule" run "${cases[@]}" --shard 3/3 --reference none --report other >/dev/null 2>&1
expect 2 'other/results.json: is of other parties: renderer (8 subpixel bits) against none' "$fillrule" merge shards/1 shards/2 other -o refused
"$fillrule" run "${cases[@]}" --shard 3/3 --reference lavapipe --profile top_left --report stricter >/dev/null 2>&1
expect 2 'stricter/results.json: is judged by profile top_left' "$fillrule" merge shards/1 shards/2 stricter -o refused
mkdir -p broken && echo '{' >broken/results.json
expect 2 'broken/results.json: is not what a run leaves behind' "$fillrule" merge broken -o refused
[ ! -e refused ] || fail 'a refused merge leaves a folder behind'
expect 2 'cannot be' "$fillrule" merge shards/1 shards/2 shards/3 -o /dev/null/merged

# Shards by GoogleTest's variables.
expect 0 'shard 2 of 3, of ' env GTEST_TOTAL_SHARDS=3 GTEST_SHARD_INDEX=1 "$fillrule" run "${cases[@]}" --report by_variables
diff <(timeless by_variables/results.json) <(timeless shards/2/results.json) >difference || fail "GoogleTest's variables split otherwise: $(head difference)"
expect 2 'GTEST_SHARD_INDEX is "3"' env GTEST_TOTAL_SHARDS=3 GTEST_SHARD_INDEX=3 "$fillrule" run "${cases[@]}"
expect 2 'GTEST_SHARD_INDEX is ""' env GTEST_TOTAL_SHARDS=3 "$fillrule" run "${cases[@]}"
for wrong in 0/3 4/3 2 a/b 1/0 /3; do expect 2 '--shard takes I/N' "$fillrule" run --shard $wrong; done

# Attachments, annotations and the summary of a fault.
faulty=('interpolation/noperspective_clipped[planes=3,w=4]' --candidate lavapipe --reference none)
expect 1 '::error file=' env GITHUB_STEP_SUMMARY=summary.md "$fillrule" run "${faulty[@]}" --annotations github --report report --junit report/junit.xml
expect 1 '::error title=Fillrule::1 of 1 case failed' "$fillrule" run "${faulty[@]}" --annotations github
grep -q '^## Fillrule: 1 of 1 case failed' summary.md || fail 'no summary'
picture=$(sed -n 's/.*\[\[ATTACHMENT|\(.*\)\]\].*/\1/p' report/junit.xml)
[ -s "$picture" ] || fail "no attachment: '$picture'"
expect 1 '' "$fillrule" run "${faulty[@]}" --annotations gitlab --report report
python3 -c 'import json; (issue,) = json.load(open("report/gl-code-quality-report.json")); assert issue["location"]["lines"]["begin"] > 1' ||
  fail 'no code quality report'

# Places that cannot be written to are refused before anything is drawn.
expect 2 '--annotations gitlab needs a report' "$fillrule" run "${faulty[@]}" --annotations gitlab
expect 2 'no/such/junit.xml: cannot be written' "$fillrule" run "${faulty[@]}" --junit no/such/junit.xml
if "$fillrule" run "${faulty[@]}" --junit no/such/junit.xml 2>&1 | grep -q 'FAILED'; then fail 'it runs before it refuses'; fi

# Names that nobody would choose: markup, quotes, an escape sequence, a line break, bytes that are no UTF-8, great length.
mkdir own
source_case=$(dirname "$schema")/../../cases/interpolation/noperspective_clipped.toml
cp "$source_case" own/$'<b>"q"\'s & \033[31m\n::error::owned]]>\xff.toml'
cp "$source_case" "own/三角形-$(printf 'x%.0s' {1..200}).toml"
"$fillrule" run own --candidate lavapipe --reference none --report hostile --junit hostile/junit.xml --annotations github --verbose >log 2>&1
[ $? -eq 1 ] || fail 'the hostile names do not fail'
if grep -q $'\033' log; then fail 'an escape sequence reaches the terminal'; fi
if grep -q '^::error::owned' log; then fail 'a name gives a command to GitHub'; fi
grep -qF '\x1b[31m\x0a::error::owned]]>\xff' log || fail 'the hostile name is not shown'
valid hostile/junit.xml
python3 -m json.tool hostile/results.json >/dev/null || fail 'results.json of hostile names'
expect 1 'merged 1 report into again' "$fillrule" merge hostile -o again --quiet
"$fillrule" show 'own/三角形-'* --candidate lavapipe --reference none --report shown >log 2>&1
# The command that a failing case ends with can be pasted, whatever the name.
command=$("$fillrule" run own --candidate lavapipe --reference none 2>&1 | sed -n 's/^    explain it: fillrule //p' | head -n 1)
expect 0 'must cover the sample' bash -c "'$fillrule' $command"

if [ "$failures" -eq 0 ]; then echo 'all CI checks passed'; fi
exit "$((failures > 0))"
