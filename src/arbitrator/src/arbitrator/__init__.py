"""Orders the candidates of each clause of a command, and builds the SMACH state machine of a plan."""
