# Says what is wrong with single lines of entry_points.tsv: a status that there is not, no reason, a
# test that does not exist, or one in a file that does not have the name of what it should call.
#
#   awk -F '\t' -v statuses=" <status> ... " -f check_lines.awk <test>... entry_points.tsv

FNR == 1 { file = FILENAME; sub(/.*\//, "", file) }

file ~ /\.cpp$/ {
  line = $0
  sub(/\/\/.*/, "", line)
  if (line ~ /^(TYPED_)?TEST\(/) {
    name = line
    sub(/^[A-Z_]*\(/, "", name)
    sub(/\).*/, "", name)
    sub(/, /, ".", name)
    is_test[file " " name] = 1
  }
  while (match(line, /[A-Za-z_][A-Za-z_0-9]*/)) {
    has_word[file, substr(line, RSTART, RLENGTH)] = 1
    line = substr(line, RSTART + RLENGTH)
  }
  next
}

index(statuses, " " $3 " ") == 0 { print $2 ": no status " $3 }
$3 !~ /^(mutable|writes)$/ && $4 == "" { print $2 ": no test and no reason" }
$3 == "works" {
  called = $5
  if (called == "") {
    called = $2
    sub(/.*::/, "", called)
  }
  if (!($4 in is_test)) print $2 ": no test " $4
  split($4, place, " ")
  if (!((place[1], called) in has_word)) print $2 ": " place[1] " does not call " called
}
