"""Words of a text and their dictionary forms: Stanza's tokenizer and lemmatizer, computed by ONNX Runtime."""
