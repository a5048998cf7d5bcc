# Lists what takes a mesh in headers of CGAL: one line for each parameter that is a mesh,
#
#   <header> TAB <name, with the namespaces within CGAL>
#
# of templates of functions in namespaces, and of constructors in templates of classes. It is no
# parser of C++: it knows comments, literals, the directives of the preprocessor, and which braces
# open a namespace, a class or a body; that is enough for headers in the style of CGAL.
#
#   awk -v root=<directory> -f declarations.awk <header>...

# ---- What is listed --------------------------------------------------------------------------

# Names that CGAL gives to types of meshes; whole words, as in TriangleMesh2, Triangle_mesh, TM1.
function is_mesh_type(type)
{
  return type ~ /^(Input|Output|Source|Target|Seam)?(Triangle|Polygon)?_?[Mm]esh(Range|In|Out)?_?[0-9AB]*$/ \
    || type ~ /^(Face|FaceList|Halfedge|HalfedgeList|EdgeList|VertexList|Input|Orig|AL_)?_?[Gg]raph(Range)?_?[0-9]*$/ \
    || type ~ /^(Input)?Polyhedron(_3)?_?[0-9]*$/ \
    || type ~ /^(TM|PM|SM|FG|HEG|G|PMesh|Poly|Primal)[0-9]?$/
}

# Other members than constructors are listed where the constructor takes no mesh.
function is_listed_member(name)
{
  return name ~ /^(parameterize|is_one_to_one_mapping|add_mesh|add_polyhedron|convert_to_polyhedron)$/ \
    || name ~ /^(reconstruct|create_from_face_graph)$/
}

# What is not for users, by CGAL's own naming.
function is_internal(name) { return name ~ /internal|[Ii]mpl(::|$)|_impl|details::/ }

# Headers that are about one type of mesh, that of this package included; and those in which graphs
# are something else: maps on planes and spheres, and cones.
function is_of_other_types(path)
{
  return path ~ /^(Surface_mesh|Nef_2|Nef_3|Nef_S2|Mesh_2|Envelope_3|Cone_spanners_2)\// \
    || path ~ /^(Polyhedron_[a-z]*_?[a-z_]*3|Construct_yao_graph_2|gnuplot_output_2)\.h$/ \
    || path ~ /^boost\/graph\/(graph_traits|properties)_|OpenMesh|[Cc]ompact_surface_mesh|^Schnyder_woods/
}

# What the mesh generators are made of. Their domains and functions stand in CGAL/ itself.
function is_part_of_meshers(path) { return path ~ /^(Mesh_3|Surface_mesher)\// }

# ---- Scopes ----------------------------------------------------------------------------------

function open_scope(kind, name, access)
{
  ++depth
  kind_of[depth] = kind
  name_of[depth] = name
  access_of[depth] = access
}

function begin_statement() { statement = ""; parentheses = 0 }

# The words of a statement without its template<...>; says in `is_template` whether it had one.
function without_template(text,    words, n, i, level, rest)
{
  n = split(text, words, " ")
  is_template = 0
  for (i = 1; i <= n && words[i] == "template"; ) {
    is_template = 1
    ++i
    level = 0
    do {
      if (words[i] == "<") ++level
      if (words[i] == ">") --level
      ++i
    } while (i <= n && level > 0)
  }
  rest = ""
  for (; i <= n; ++i)
    rest = rest " " words[i]
  return substr(rest, 2)
}

function open_brace(    text, words, n, i, name)
{
  text = without_template(statement)
  if (text ~ /(^| )namespace( |$)/) {
    name = text
    sub(/.*namespace ?/, "", name)
    open_scope("namespace", name, "public")
  } else if (text ~ /^extern ""$/) {
    open_scope("namespace", "", "public")
  } else if (text ~ /^(class|struct|union) / && text !~ /\(/) {
    n = split(text, words, " ")
    name = ""
    for (i = 2; i <= n && words[i] !~ /^(:|<|final)$/; ++i)
      if (words[i] ~ /^[A-Za-z_]/) name = words[i]
    open_scope("class", name, text ~ /^class/ ? "private" : "public")
    template_of[depth] = is_template || kind_of[depth - 1] == "class" && template_of[depth - 1]
  } else {
    declaration(statement)
    open_scope("body", "", "")
  }
  begin_statement()
}

function take_word(word)
{
  if (kind_of[depth] == "body") {
    if (word == "{") open_scope("body", "", "")
    if (word == "}") { --depth; begin_statement() }
    return
  }
  if (word == "(") ++parentheses
  if (word == ")") --parentheses
  if (parentheses <= 0) {
    if (word == "{") { open_brace(); return }
    if (word == "}") { if (depth > 0) --depth; begin_statement(); return }
    if (word == ";") { declaration(statement); begin_statement(); return }
    if (word == ":" && statement ~ /^(public|private|protected)$/) {
      access_of[depth] = statement
      begin_statement()
      return
    }
  }
  statement = statement == "" ? word : statement " " word
}

# ---- Declarations ----------------------------------------------------------------------------

# The place of the parenthesis before the parameters of a function, or 0.
function parameters_begin(words, n,    i, level, inner)
{
  level = 0
  for (i = 1; i <= n; ++i) {
    if (words[i] == "<") ++level
    else if (words[i] == ">" && level > 0) --level
    else if (words[i] == "=" && level == 0) return 0
    else if (words[i] == "(" && level == 0) {
      if (words[i - 1] !~ /^(decltype|noexcept|BOOST_.*|CGAL_[A-Z_]*)$/) return i
      for (inner = 1; i < n && inner > 0; ) {
        ++i
        if (words[i] == "(") ++inner
        if (words[i] == ")") --inner
      }
    }
  }
  return 0
}

# The last word of the type that is taken by reference, or nothing.
function referred_type(parameter)
{
  sub(/ = .*/, "", parameter)
  if (parameter !~ / &/) return ""
  sub(/ &.*/, "", parameter)
  gsub(/ (const|typename)/, "", parameter)
  if (parameter ~ />$/) return ""
  sub(/.* /, "", parameter)
  return parameter
}

function declaration(text,    words, n, i, level, begin, name, in_class, parameter, found)
{
  in_class = kind_of[depth] == "class"
  if (in_class && access_of[depth] != "public") return
  text = without_template(text)
  if (!is_template && !(in_class && template_of[depth])) return
  if (text ~ /^(using|typedef|friend|static_assert|class|struct|enum|union|extern) /) return
  n = split(text, words, " ")
  begin = parameters_begin(words, n)
  if (begin < 2) return
  name = words[begin - 1]
  # No operators, and no members that are defined outside of their class.
  if (name !~ /^[A-Za-z_]/ || name == "operator" || begin > 2 && words[begin - 2] ~ /^(operator|::|~)$/) return
  if (in_class && name != name_of[depth] && !is_listed_member(name)) return

  level = found = 0
  parameter = ""
  for (i = begin + 1; i <= n && level >= 0; ++i) {
    if (words[i] ~ /^[(<[{]$/) ++level
    if (words[i] ~ /^[])>}]$/) --level
    if (level < 0 || level == 0 && words[i] == ",") {
      if (is_mesh_type(referred_type(parameter))) found = 1
      parameter = ""
    } else
      parameter = parameter " " words[i]
  }
  if (!found) return

  if (in_class && name == name_of[depth]) name = ""
  for (i = depth; i >= 1; --i)
    if (name_of[i] != "") name = name_of[i] (name == "" ? "" : "::" name)
  sub(/^CGAL::/, "", name)
  if (!is_internal(name)) print header "\t" name
}

# ---- Lines -----------------------------------------------------------------------------------

# A line without comments, and with empty literals.
function code_of(line,    code, mark)
{
  code = ""
  while (line != "") {
    if (in_comment) {
      if (!match(line, /\*\//)) return code
      line = substr(line, RSTART + 2)
      in_comment = 0
    } else {
      if (!match(line, /\/\/|\/\*|"|'/)) return code line
      code = code substr(line, 1, RSTART - 1)
      mark = substr(line, RSTART, RLENGTH)
      line = substr(line, RSTART + RLENGTH)
      if (mark == "//") return code
      if (mark == "/*") { code = code " "; in_comment = 1 }
      if (mark == "\"") { code = code "\"\""; if (match(line, /^([^"\\]|\\.)*"/)) line = substr(line, RLENGTH + 1) }
      if (mark == "'") { code = code "0"; if (match(line, /^([^'\\]|\\.)[^']*'/)) line = substr(line, RLENGTH + 1) }
    }
  }
  return code
}

# Both branches of a condition are read, the second from where the first began.
function directive(line)
{
  if (line ~ /^[ \t]*#[ \t]*if/) {
    ++conditions
    old_depth[conditions] = depth
    old_parentheses[conditions] = parentheses
    old_statement[conditions] = statement
  } else if (line ~ /^[ \t]*#[ \t]*el/) {
    depth = old_depth[conditions]
    parentheses = old_parentheses[conditions]
    statement = old_statement[conditions]
  } else if (line ~ /^[ \t]*#[ \t]*endif/)
    --conditions
}

FNR == 1 {
  header = substr(FILENAME, length(root) + 2)
  is_skipped = is_of_other_types(header) || is_part_of_meshers(header)
  depth = conditions = in_comment = in_directive = 0
  begin_statement()
}
is_skipped { next }
in_directive { in_directive = /\\$/; next }
{
  sub(/\r$/, "")
  line = code_of($0)
  if (line ~ /^[ \t]*#/) {
    directive(line)
    in_directive = line ~ /\\$/
    next
  }
  while (match(line, /[A-Za-z_0-9]+|::|&&|[^ \t]/)) {
    take_word(substr(line, RSTART, RLENGTH))
    line = substr(line, RSTART + RLENGTH)
  }
}
