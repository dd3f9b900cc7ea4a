"""The engine: identifies the payload of a robot, safely. Knows no web server and no viewer."""
