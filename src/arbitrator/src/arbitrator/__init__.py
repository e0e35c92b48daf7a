"""Orders the ways to carry out each clause of a command and forms a SMACH state machine of them."""
