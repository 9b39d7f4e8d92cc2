# shellcheck shell=bash
# What the checks of the boards' modules share: steps that run quietly, what they measured, what is left out. For ". steps.bash" in the
# folder of the module.
mkdir -p build
log=$PWD/build/check.log
: > "$log"
failed=0
besides=()
pids=()
trap 'kill ${pids[@]+"${pids[@]}"} 2> /dev/null' EXIT # a background process does not see Ctrl-C
figures=()
left_out=()

has() { command -v "$1" > /dev/null; }

leave_out() { left_out+=("$1: $2"); }

# step NAME COMMAND...: runs it; lines of its output that begin with two spaces are figures.
step() {
  local begin=$SECONDS
  printf '%-52s' "$1"
  run "$@" > build/step.log
  report $? $((SECONDS - begin)) build/step.log
}

# beside NAME COMMAND...: begins a step. The steps below run at the same time, and must make other files.
beside() {
  run "$@" > "build/beside-${#besides[@]}.log" &
  besides+=("$1")
  pids+=($!)
}

run() {
  echo "== $1: ${*:2}"
  "${@:2}" 2>&1
}

# report STATUS SECONDS LOG: shows how a step ended.
report() {
  if [ "$1" -eq 0 ]; then
    printf 'ok   %4d s\n' "$2"
    while IFS= read -r line; do figures+=("$line"); done < <(grep -E '^  [^ ]' "$3")
  else
    printf 'FAIL\n'
    tail -n 25 "$3" | sed 's/^/    /'
    failed=1
  fi
  cat "$3" >> "$log"
}

# await: shows how the steps of "beside" ended, with the seconds that they were awaited.
await() {
  local i begin
  for i in "${!besides[@]}"; do
    begin=$SECONDS
    printf '%-52s' "${besides[i]}"
    wait "${pids[i]}"
    report $? $((SECONDS - begin)) "build/beside-$i.log"
  done
  besides=() pids=()
}

# finish [ADVICE]: awaits the steps that still run, shows what was measured and left out, and ends.
finish() {
  await
  [ ${#figures[@]} -eq 0 ] || printf '%s\n' '' 'figures' "${figures[@]}"
  [ ${#left_out[@]} -eq 0 ] || printf '%s\n' '' 'left out' "${left_out[@]/#/  }" ${1:+"  $1"}
  printf '\nlog: %s\n' "$log"
  exit $failed
}

# usage: shows the comment at the beginning of the script, and ends.
usage() {
  sed -n '2,/^[^#]/{/^#/s/^# \{0,1\}//p}' "$0"
  exit 2
}
