# Where the errors in the messages of g++ come from: the numbers of the lines of the file `name` that have one, or that
# require what has one. An error that comes from no line of the file is given by its own place.

BEGIN {
  at_a_line = name
  gsub(/[.+]/, "[&]", at_a_line)
  at_a_line = "^" at_a_line ":[0-9]+:"
}

function print_line_number() { split($0, parts, ":"); print parts[2] }

# g++ says in what it is, and what requires that, only when this has changed since its last message.
/^[^ ].*: (In|At) .*:$/ { is_required = 0 }
/^[^ ].*:[0-9]+:   / && $0 ~ at_a_line {
  is_required = 1
  print_line_number()
}
/^[^ ].*: (fatal |internal compiler )?error: / {
  if ($0 ~ at_a_line)
    print_line_number()
  else if (!is_required) {
    sub(/: (fatal |internal compiler )?error: .*/, "")
    print
  }
}
