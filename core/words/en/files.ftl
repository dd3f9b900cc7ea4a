# Paths
files-leads-outside =
    .found = '{ $name }', which leads outside the folder
    .expected = a file inside it
files-missing =
    .found = no such file
    .expected = the file '{ $name }' in { $folder }
files-no-regular-file =
    .found = something that is no file
    .expected = the file '{ $name }' in { $folder }
files-path-not-followed =
    .found = a path that cannot be followed ({ $reason })
    .expected = a file inside the folder
# What is in them
files-too-large =
    .found = { $bytes } bytes
    .expected = at most { $most }
files-not-utf8 =
    .found = the byte { $byte } at position { $position }
    .expected = text in UTF-8
files-unreadable =
    .found = a file that cannot be read ({ $reason })
    .expected = a readable file
files-reader-ended =
    .found = a file on which its reader ended, at most { $most_s } s of computing time and { SIGNIFICANT($most_gb, digits: 3) } GB allowed
    .expected = a mesh of ordinary size
