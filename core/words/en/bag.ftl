# Bags of ROS and MCAP files.
bag-broken =
    .found = a bag that cannot be read ({ $reason })
    .expected = a complete MCAP file, bag of ROS 1 or folder of a bag of ROS 2; `mcap recover` mends one that was cut off
bag-too-many-topics =
    .found = more than { $most } topics
    .expected = a bag with fewer; `ros2 bag convert` or `mcap filter` picks some
