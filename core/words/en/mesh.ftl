# Any mesh
mesh-scale-not-positive =
    .found = the scale { $scale }
    .expected = positive factors
mesh-file-empty =
    .found = an empty file
    .expected = a mesh
mesh-unknown-kind =
    .found = a file of the kind '{ $kind }'
    .expected = one of { $kinds }
mesh-unreadable =
    .found = a mesh that cannot be read ({ $reason })
    .expected = a sound STL, OBJ or DAE file
mesh-unreadable-for-second-opinion =
    .found = a mesh that the second opinion on plans cannot read ({ $reason })
    .expected = an STL, OBJ or DAE file
mesh-empty =
    .found = no triangle
    .expected = a mesh with triangles
mesh-not-finite =
    .found = a vertex that is no number (NaN or infinite)
    .expected = finite coordinates
mesh-too-large =
    .found = a vertex { SIGNIFICANT($distance_m, digits: 4) } m from the origin
    .expected = at most { SIGNIFICANT($most_m, digits: 3) } m; millimetres have the scale 0.001
mesh-too-many-triangles =
    .found = { $triangles } triangles
    .expected = at most { $most }
mesh-no-such-vertex =
    .found = a face of vertices that there are not
    .expected = numbers of its { $vertices } vertices
mesh-flat =
    .found = { $vertices ->
        [one] { $vertices } vertex
       *[other] { $vertices } vertices
    } in one plane, { SIGNIFICANT($x_m, digits: 3) } x { SIGNIFICANT($y_m, digits: 3) } x { SIGNIFICANT($z_m, digits: 3) } m
    .expected = a solid, of four vertices or more that are in no plane
# STL
mesh-incomplete-triangle =
    .found = { $vertices ->
        [one] { $vertices } vertex
       *[other] { $vertices } vertices
    }
    .expected = three for each triangle of an ASCII STL file
mesh-stl-breaks-off =
    .found = an STL file that breaks off at { $bytes } bytes
    .expected = 84 bytes, and 50 for each of its triangles
# DAE
mesh-dae-dead-link =
    .found = a link to '{ $name }', which there is not
    .expected = a DAE file that is complete in itself
mesh-dae-too-deep =
    .found = nodes nested more than { $most } deep
    .expected = a scene without rings
mesh-dae-too-many-elements =
    .found = more than { $most } elements in its scene
    .expected = a scene of fewer
mesh-dae-declaration =
    .found = the declaration { $declaration }
    .expected = a DAE file without document types and entities
mesh-dae-does-not-parse =
    .found = XML that does not parse ({ $reason })
    .expected = a DAE file
