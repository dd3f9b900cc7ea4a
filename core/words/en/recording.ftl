# Where in a recording. $file is the file, or the recording in memory.
recording-itself = recording
recording-column = { $file }: column '{ $column }'
recording-column-row = { $file }: column '{ $column }', row { $row }
recording-row = { $file }: row { $row }
recording-appended = what is appended
recording-appended-gravity = what is appended: gravity
# The folder.
recording-no-folder =
    .found = no such folder
    .expected = a folder with recording.json and samples
recording-there-already =
    .found = something that is already there
    .expected = a new or empty folder; a recording is never overwritten
recording-folder-not-made =
    .found = a folder that cannot be made ({ $reason })
    .expected = a new folder
# recording.json
recording-broken-json =
    .found = JSON that does not parse ({ $reason })
    .expected = JSON
recording-no-json-object =
    .found = JSON that is no object
    .expected = a JSON object
recording-no-format =
    .found = no such key
    .expected = '{ $known }'
recording-unknown-format =
    .found = '{ $format }'
    .expected = '{ $known }'
recording-misspelt-key =
    .found = an unknown key
    .expected = '{ $meant }', if that is what was meant
recording-gravity-not-of-the-earth =
    .found = { $gravity_m_s2 } m/s2
    .expected = about 9.81 m/s2, in the base frame
recording-friction-of-other-joints =
    .found = { $count ->
        [one] { $count } value
       *[other] { $count } values
    }
    .expected = { $joints }, one for each joint
recording-no-rigid-body =
    .found = { $phi }
    .expected = mass, first moment and inertia that a rigid body can have
recording-unknown-joint =
    .found = '{ $joint }'
    .expected = joints of the URDF: { $joints }
recording-unknown-link =
    .found = '{ $link }'
    .expected = a link of the URDF: { $links }
recording-other-chain =
    .found = { $joints }
    .expected = the chain's joints in its order: { $chain }
# The samples.
recording-no-samples =
    .found = no samples
    .expected = exactly one of { $files }
recording-several-samples =
    .found = { $present }
    .expected = exactly one of { $files }
recording-broken-parquet =
    .found = Parquet that cannot be read ({ $reason })
    .expected = a complete Parquet file
recording-broken-csv =
    .found = CSV that cannot be read ({ $reason })
    .expected = CSV in UTF-8 with a header
recording-unpacks-too-large =
    .found = more than { $most_bytes } bytes when unpacked
    .expected = a recording of a plausible size
recording-rows =
    .found = { $rows ->
        [one] { $rows } row
       *[other] { $rows } rows
    }
    .expected = 2 to { $most }
recording-values-of-row =
    .found = { $count ->
        [one] { $count } value
       *[other] { $count } values
    }
    .expected = { $columns }, one for each column
recording-column-repeated =
    .found = { $count } of them
    .expected = one
recording-no-column =
    .found = no such column
    .expected = it beside { $columns }
recording-more-columns-than-joints =
    .found = more columns than joints
    .expected = { $first } to { $last }
recording-neither-wrench-nor-torques =
    .found = neither a wrench (fx .. tz) nor joint torques (tau_1 ..)
    .expected = at least one of them
recording-joints-without-robot =
    .found = joint positions without a robot
    .expected = joints with `robot` in recording.json, or poses
recording-neither-joints-nor-poses =
    .found = neither joint positions (q_1 ..) nor poses (qx qy qz qw)
    .expected = joints with `robot` in recording.json, or poses
recording-no-numbers =
    .found = values of the type { $type }
    .expected = numbers
recording-no-texts =
    .found = values of the type { $type }
    .expected = text
recording-numbers-as-text =
    .found = numbers written as text
    .expected = numbers
recording-no-number =
    .found = no value
    .expected = a finite number
recording-no-text =
    .found = no value
    .expected = text
recording-text-for-number =
    .found = the text '{ $text }'
    .expected = a number
recording-not-finite =
    .found = { $value }
    .expected = a finite number
recording-other-length =
    .found = { $count ->
        [one] { $count } value
       *[other] { $count } values
    }
    .expected = { $times }, as many as times
recording-time-not-increasing =
    .found = { SIGNIFICANT($time_s, digits: 9) } s after { SIGNIFICANT($before_s, digits: 9) } s
    .expected = time that strictly increases
recording-no-unit-quaternion =
    .found = a norm of { SIGNIFICANT($norm, digits: 4) }
    .expected = a unit quaternion
recording-unknown-phase =
    .found = '{ $phase }'
    .expected = transfer, hold:<axis><sign>, hold:free or rotate:<axis>
# What is appended to a recording.
recording-other-robot =
    .found = another robot
    .expected = the robot of the recording
recording-other-gravity =
    .found = { $gravity_m_s2 } m/s2
    .expected = that of the recording, { $before_m_s2 } m/s2
recording-condensed = The recording is long: of every { $rows } rows the mean is used ({ $means } in all). What only single rows show, such as copies of rows, is not looked for.
