"""The stages of the pipeline in one process."""
