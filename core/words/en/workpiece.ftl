workpiece-tool-without-std = The uncertainty of the tool { $tool } is unknown ({ $keys } not stated): the workpiece's intervals have no share from it and may be too narrow.
workpiece-no-rigid-body = What is left without the tools is no rigid body: the workpiece is too light to be told from nothing, or a tool is not what is stated of it.
