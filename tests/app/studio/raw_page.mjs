// Program as a server, and a client without a browser that reads only on demand.

import {spawn} from "node:child_process";
import {randomBytes} from "node:crypto";
import {connect} from "node:net";

/** Starts the studio with these arguments; resolves to its process and its address. */
export async function startStudio(folder, ...args) {
  const server = spawn(process.env.STEPWIRE_PROGRAM, ["studio", "--no-open", ...args], {stdio: ["ignore", "pipe", "inherit"], env: {...process.env, XDG_STATE_HOME: folder}});
  const address = await new Promise((resolve, reject) => {
    let text = "";
    server.once("exit", () => reject(new Error("the studio has ended")));
    server.stdout.on("data", (more) => {
      const found = /http:\/\/\S+/.exec((text += more));
      if (found) resolve(found[0]);
    });
  });
  return {server, address};
}

/** WebSocket client that reads only on demand, so that it can stall. */
export class Page {
  constructor(address) {
    this.address = new URL(address);
    this.answers = new Map();
    this.next = 1;
    this.rest = Buffer.alloc(0);
  }
  async open() {
    const {host, hostname, port, searchParams} = this.address;
    this.socket = connect(Number(port), hostname);
    this.socket.setNoDelay(true);  // as browsers do
    const key = randomBytes(16).toString("base64");
    this.socket.write(`GET /socket HTTP/1.1\r\nHost: ${host}\r\nOrigin: http://${host}\r\nCookie: stepwire-${port}=${searchParams.get("token")}\r\n` +
      `Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: ${key}\r\n\r\n`);
    let head = "";
    await new Promise((resolve, reject) => {
      const take = (bytes) => {
        head += bytes.toString("latin1");
        const end = head.indexOf("\r\n\r\n");
        if (end < 0) return;
        this.socket.off("data", take);
        head.startsWith("HTTP/1.1 101") ? resolve() : reject(new Error(head));
        this.take(Buffer.from(head.slice(end + 4), "latin1"));
      };
      this.socket.on("data", take);
      this.socket.on("error", reject);
    });
    this.socket.on("data", (bytes) => this.take(bytes));
    return this;
  }
  take(bytes) {
    this.rest = Buffer.concat([this.rest, bytes]);
    while (this.rest.length >= 2) {
      const short = this.rest[1] & 127, head = short === 126 ? 4 : short === 127 ? 10 : 2;
      if (this.rest.length < head) return;
      const length = short === 126 ? this.rest.readUInt16BE(2) : short === 127 ? Number(this.rest.readBigUInt64BE(2)) : short;
      if (this.rest.length < head + length) return;
      const body = this.rest.subarray(head, head + length);
      if ((this.rest[0] & 15) === 1) this.heard(JSON.parse(body.toString()));
      if ((this.rest[0] & 15) === 2) this.onframe?.(body);
      if ((this.rest[0] & 15) === 9) this.send(body, 10);
      this.rest = this.rest.subarray(head + length);
    }
  }
  heard(message) {
    const waits = this.answers.get(message.id);
    if (waits) message.fault ? waits.reject(new Error(message.fault.text)) : waits.resolve(message.result);
  }
  send(body, kind = 1) {
    const mask = randomBytes(4), masked = Buffer.from(body);
    for (let i = 0; i < masked.length; ++i) masked[i] ^= mask[i % 4];
    const head = masked.length < 126 ? Buffer.from([128 | kind, 128 | masked.length]) : Buffer.from([128 | kind, 254, masked.length >> 8, masked.length & 255]);
    this.socket.write(Buffer.concat([head, mask, masked]));
  }
  call(call, args = {}) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.answers.set(id, {resolve, reject});
      this.send(JSON.stringify({id, call, ...args}));
    });
  }
  stall() {
    this.socket.pause();
  }
  close() {
    this.socket.destroy();
  }
}
