"""What needs a person: alarms, from when they are raised until they are over and acknowledged."""
