"""The generated set of questions, reports, wishes, prohibitions, talk and requests over the examples of all units."""
