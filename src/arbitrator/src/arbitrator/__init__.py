"""Orders the ways to carry out a command and forms a SMACH state machine of them."""
