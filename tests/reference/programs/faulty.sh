#!/bin/sh
# An engine of one body that does not move, and misbehaves as its argument says.
fault=$1
state='[0,5,0,0,0,0]'
hello='{"plumb-engine":1,"name":"faulty","version":"1","options":[{"key":"knob","value":"1","about":"nothing","min":0,"max":2,"ladder":["0","1","2"]}]}'
stepping='{"stepping":{"arithmetic":"double"}}'
built="{\"states\":[$state]}"
number=0
say() { printf '%s\n' "$1"; }

# The faults of a step, which is when most engines fail.
one_step() {
  number=$((number + 1))
  at="\"step\":$number"
  step="{$at,\"states\":[$state],\"ns\":1}"
  case $fault in
    crash) kill -SEGV $$ ;;
    abort) echo 'assertion failed: x > 0' >&2; kill -ABRT $$ ;;
    exits-with-0) exit 0 ;;
    exits-with-3) echo 'no more' >&2; exit 3 ;;
    hangs) sleep 60 ;;
    garbage) say 'step done!' ;;
    half-a-line) printf '{"states":[['; exit 0 ;;
    no-object) say '[1,2]' ;;
    bad-utf8) printf '{%s,"states":[%s],"ns":1,"\377":1}\n' "$at" "$state" ;;
    nan) say "{$at,\"states\":[[NaN,5,0,0,0,0]],\"ns\":1}" ;;
    null) say "{$at,\"states\":[[null,5,0,0,0,0]],\"ns\":1}" ;;
    infinite) say "{$at,\"states\":[[1e999,5,0,0,0,0]],\"ns\":1}" ;;
    diverges) say "{$at,\"states\":[[1e30,5,0,0,0,0]],\"ns\":1}" ;;
    no-bodies) say "{$at,\"states\":[],\"ns\":1}" ;;
    too-many-bodies) say "{$at,\"states\":[$state,$state],\"ns\":1}" ;;
    five-numbers) say "{$at,\"states\":[[0,5,0,0,0]],\"ns\":1}" ;;
    words) say "{$at,\"states\":[[\"0\",5,0,0,0,0]],\"ns\":1}" ;;
    # In base64: 6 numbers of which one is not a number, 5 numbers, 12 numbers, and none.
    packed-nan) say "{$at,\"ns\":1,\"states\":\"AAAAAAAAAAAAAAAAAAAUQAAAAAAAAAAAAAAAAAAA+H8AAAAAAAAAAAAAAAAAAAAA\"}" ;;
    packed-five) say "{$at,\"ns\":1,\"states\":\"AAAAAAAAAAAAAAAAAAAUQAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA==\"}" ;;
    packed-too-many) say "{$at,\"ns\":1,\"states\":\"AAAAAAAAAAAAAAAAAAAUQAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAUQAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA\"}" ;;
    packed-garbage) say "{$at,\"ns\":1,\"states\":\"zero, five\"}" ;;
    packed) say "{$at,\"ns\":1,\"states\":\"AAAAAAAAAAAAAAAAAAAUQAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA\",\"contacts\":\"\"}" ;;
    no-time) say "{$at,\"states\":[$state]}" ;;
    negative-time) say "{$at,\"states\":[$state],\"ns\":-1}" ;;
    lies-about-time) say "{$at,\"states\":[$state],\"ns\":1e13}" ;;
    contact-of-nobody) say "{$at,\"states\":[$state],\"ns\":1,\"contacts\":[[0,7,0,0,0,1,1,0,0]]}" ;;
    contact-without-direction) say "{$at,\"states\":[$state],\"ns\":1,\"contacts\":[[0,0,0,0,0,0,1,0,0]]}" ;;
    says-too-much) say "$step"; say "$step" ;;
    skips-a-step) number=$((number + 1)); say "$step" ;;
    says-error) say '{"error":"my solver gave up"}' ;;
    closes-output) exec 1>&-; sleep 60 ;;
    floods) yes | tr -d '\n' ;;
    logs-a-lot) i=0; while [ $i -lt 2000 ]; do echo "line $i of a long log" >&2; i=$((i + 1)); done; say "$step" ;;
    *) say "$step" ;;
  esac
}

while read -r ask; do
  case $ask in
    *'"hello"'*)
      case $fault in
        silent) sleep 60 ;;
        other-protocol) say '{"plumb-engine":2,"name":"faulty","version":"1"}' ;;
        name-with-space) say '{"plumb-engine":1,"name":"my engine","version":"1"}' ;;
        *) say "$hello" ;;
      esac ;;
    *'"stepping"'*)
      case $fault in
        states-nonsense) say '{"stepping":{"arithmetic":"double","skin":-1}}' ;;
        crashes-when-asked-how) kill -SEGV $$ ;;
        *) say "$stepping" ;;
      esac ;;
    *'"build"'*)
      number=0
      case $fault in
        crashes-in-build) kill -SEGV $$ ;;
        refuses) say '{"notSupported":"too round"}' ;;
        *) say "$built" ;;
      esac ;;
    *'"step"'*)
      count=${ask##*'"count":'}
      count=${count%%[,\}]*}
      while [ "$count" -gt 0 ]; do one_step; count=$((count - 1)); done ;;
    *'"end"'*) exit 0 ;;
    *) say '{"error":"unknown ask"}' ;;
  esac
done
