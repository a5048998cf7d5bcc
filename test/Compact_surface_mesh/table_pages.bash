# For scripts that keep a table in which each line has a status, and a page of the manual that is made of it.
#
# A script that reads this sets
#   table, page     the files: columns of the table are separated by TAB
#   status_column   the number of the column of the status
#   meanings        lines: status TAB title TAB meaning
#   label           what the labels of the page's sections begin with
# and has two functions: print_introduction, and print_lines STATUS, which prints the lines of a status as a table of
# Doxygen.
# shellcheck shell=bash disable=SC2154

lines_of() { awk -F '\t' -v column="$status_column" -v status="$1" '$column == status' "$table"; }

# print_page COUNTED: COUNTED is what a line of the table is, in the plural
print_page() {
  print_introduction
  printf '\n| Status | %s |\n| :----- | --------: |\n' "$1"
  local status title meaning n
  while IFS=$'\t' read -r status title meaning; do
    n=$(lines_of "$status" | wc -l)
    [ "$n" -eq 0 ] || printf '| \\ref %s_%s "%s" | %s |\n' "$label" "$status" "$title" "$n"
  done <<< "$meanings"
  echo "| Together | $(wc -l < "$table") |"
  while IFS=$'\t' read -r status title meaning; do
    [ "$(lines_of "$status" | wc -l)" -gt 0 ] || continue
    printf '\n\\section %s_%s %s\n\n' "$label" "$status" "$title"
    echo "$meaning" | fold -s -w 110 | sed 's/ *$//'
    echo
    print_lines "$status"
  done <<< "$meanings"
  printf '\n*/\n'
}

errors=0
error() { echo "${0##*/}: $*" >&2; errors=$((errors + 1)); }

# complain MESSAGE: for each line of the input
complain() { local line; while IFS= read -r line; do error "$1: ${line//$'\t'/ }"; done; }

# complain_of_order FILE: about lines that are not sorted, or stand twice
complain_of_order() {
  complain "not sorted, or twice in the table" < <(sort -u "$1" | diff "$1" - | grep '^<' || true)
}

# check_page COUNTED SCRATCH: whether the page is that of the table; SCRATCH is a folder
check_page() {
  print_page "$1" > "$2/page"
  cmp -s "$2/page" "$page" ||
    error "${page##*/} is not made from the table; run: ${0##*/} page > doc/Compact_surface_mesh/${page##*/}"
}

finish_check() { [ "$errors" -eq 0 ] || exit 1; }
