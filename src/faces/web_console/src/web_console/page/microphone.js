// The microphone of this computer: its sound goes to the robot while it is on. Browsers give it to pages of this machine only.

const RATE = 16000;

export class Microphone {
  constructor(send) {
    this.send = send;
    this.stream = this.context = null;
  }

  get isThere() {
    return Boolean(navigator.mediaDevices && window.AudioWorkletNode);
  }

  get isOn() {
    return this.context !== null;
  }

  async begin() {
    this.stream = await navigator.mediaDevices.getUserMedia({ audio: { channelCount: 1, echoCancellation: true } });
    this.context = new AudioContext({ sampleRate: RATE });
    await this.context.audioWorklet.addModule("microphone_worklet.js");
    const parts = new AudioWorkletNode(this.context, "parts", { numberOfOutputs: 0 });
    parts.port.onmessage = (event) => this.send(event.data);
    this.context.createMediaStreamSource(this.stream).connect(parts);
  }

  async end() {
    const { stream, context } = this;
    this.stream = this.context = null;
    if (stream) for (const track of stream.getTracks()) track.stop();
    if (context) await context.close();
  }
}
