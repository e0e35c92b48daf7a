// Makes parts of 0.1 s of the sound: 16 bit.

const SAMPLES = 1600;

class Parts extends AudioWorkletProcessor {
  constructor() {
    super();
    this.part = new Int16Array(SAMPLES);
    this.count = 0;
  }

  process([[channel]]) {
    for (const sample of channel || []) {
      this.part[this.count++] = Math.max(-32768, Math.min(32767, Math.round(32768 * sample)));
      if (this.count === SAMPLES) {
        this.port.postMessage(this.part.buffer.slice(0));
        this.count = 0;
      }
    }
    return true;
  }
}

registerProcessor("parts", Parts);
