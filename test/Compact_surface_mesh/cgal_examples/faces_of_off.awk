# The faces of an OFF file as lines that do not depend on the numbers of vertices, nor on where a face begins: the
# coordinates of its vertices in turn. Vertices without a face are lines with one point.

{ sub(/\r$/, "") }
/^[ \t]*(#|$)/ { next }
!has_header && /^[A-Z]*OFF/ {
  has_header = 1
  sub(/^[A-Z]*OFF[ \t]*/, "")
  if ($0 == "") next
}
!has_counts {
  has_counts = 1
  num_vertices = $1
  next
}
n < num_vertices {
  point[n++] = $1 " " $2 " " $3
  next
}
{
  least = ""
  for (first = 0; first < $1; ++first) {
    face = ""
    for (i = 0; i < $1; ++i) {
      v = $(2 + (first + i) % $1)
      is_used[v] = 1
      face = face (i == 0 ? "" : ", ") point[v]
    }
    if (first == 0 || face < least) least = face
  }
  print least
}
END {
  for (v = 0; v < n; ++v)
    if (!(v in is_used)) print point[v]
}
