library-unknown = tool library of cell "{ $cell }": there is nothing with the identifier "{ $saved }". List what there is and ask again.
library-name-taken = name: "{ $name }" is taken in cell "{ $cell }" by { $by ->
    [obstacle] an obstacle
    [zone] a protected zone
    [tool] a tool of cell.toml
    [payload] a payload of cell.toml
   *[saved] a payload of the tool library
}; choose another
library-full = tool library of cell "{ $cell }": it holds { $most_saved } payloads already; delete one that is no longer used
library-run-of-other-cell = run "{ $run }": is not one of cell "{ $cell }"; save it in the cell in which it was made
library-without-box = box: nothing says what certainly contains "{ $name }"; state its size, and where it is from the sensor on
library-mass-range =
    .found = { SIGNIFICANT($least_kg, digits: 6) } kg
    .expected = at most the upper end of the range, { SIGNIFICANT($most_kg, digits: 6) } kg
