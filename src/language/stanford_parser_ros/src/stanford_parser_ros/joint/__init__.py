"""One network on a pretrained encoder tags words and finds their heads; it runs in ONNX Runtime."""
