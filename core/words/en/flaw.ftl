# What is wrong with something, made of the two parts that a flaw's message has.
# $where (text) - the file, with the key, column or row in it
flaw = { $where }: found { $found }, expected { $expected }
    .found = { $found }
    .expected = { $expected }
# A sentence as it is: of a program outside Heft, or stored by an earlier version.
text = { $text }
