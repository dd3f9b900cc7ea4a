# What a xacro file or its expansion is refused for.
xacro-declaration =
    .found = a document type or an entity
    .expected = a URDF or xacro file without them
xacro-arguments-of-urdf =
    .found = a plain URDF with --xacro-arg
    .expected = a xacro file, or none of these arguments
xacro-too-slow =
    .found = xacro that is not expanded after { FIXED($limit_s, digits: 0) } s
    .expected = a xacro file that ends
xacro-ended =
    .found = xacro that does not expand (the process ended with { $status }: time or memory)
    .expected = a xacro file that needs less of both
xacro-not-expanded =
    .found = xacro that does not expand ({ $reason })
    .expected = xacro, its arguments given as --xacro-arg NAME:=VALUE
xacro-unwanted =
    .found = xacro that wants { $wanted }
    .expected = no $(eval ...); files in its folder or a --package-path DIR

# What it wants.
xacro-wants-package = $(find { $name })
xacro-wants-eval = $(eval ...)
xacro-wants-attribute = the attribute { $name } in an expression
xacro-wants-name = the name { $name } in an expression
xacro-wants-file = the file { $file }
xacro-wants-system = { $event }
xacro-long-expression = an expression of { $characters } characters
xacro-long-urdf = { $characters } characters of URDF
