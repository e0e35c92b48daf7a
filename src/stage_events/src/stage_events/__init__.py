"""What a stage of the pipeline says of a command, and its last word for listeners that connect late."""
