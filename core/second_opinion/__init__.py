"""What checks a finished plan: it shares no code with what makes one."""
