// Files of `run --files mcap`, read as a viewer does: with the reader from npm, which checks every checksum.

import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {after, test} from "node:test";

const mcap = await import("@mcap/core").catch(() => null);
const missing = mcap ? false : "@mcap/core is not installed; ./stepwire setup tests installs it";
const folder = mkdtempSync(join(tmpdir(), "stepwire-mcap-"));
after(() => rmSync(folder, {recursive: true}));

/// The cart of a ramp, which has gone t^2 / 2 at t.
const diagram = `stepwire: 1
title: A ramp
step: 1 ms
stop: 30 s
solver: rk4
parameters:
  slope: {value: 1 m/s}
blocks:
  speed: {block: Constant, value: $slope}
  way:   {block: Integrator, u: speed}
record: [speed, way]
`;

async function readerOf(text) {
  writeFileSync(join(folder, "ramp.yaml"), text);
  const {status, stderr} = spawnSync(process.env.STEPWIRE_PROGRAM, ["run", "ramp.yaml", "--files", "mcap", "--out", "out"], {cwd: folder});
  assert.equal(status, 0, String(stderr));
  const file = readFileSync(join(folder, "out/signals.mcap"));
  const readable = {
    size: async () => BigInt(file.length),
    read: async (offset, size) => new Uint8Array(file.subarray(Number(offset), Number(offset + size))),
  };
  return {file, reader: await mcap.McapIndexedReader.Initialize({readable})};
}

async function messagesOf(reader, call = {}) {
  const messages = [];
  for await (const message of reader.readMessages(call))
    messages.push({time: message.logTime, ...JSON.parse(new TextDecoder().decode(message.data))});
  return messages;
}

test("a run is a channel of JSON messages that the index finds by their time", {skip: missing}, async () => {
  const {reader} = await readerOf(diagram);
  const [channel] = reader.channelsById.values();
  assert.equal(channel.topic, "signals");
  assert.equal(channel.messageEncoding, "json");
  const schema = JSON.parse(new TextDecoder().decode(reader.schemasById.get(channel.schemaId).data));
  assert.equal(schema.properties.way.unit, "m");
  assert.equal(reader.statistics.messageCount, 30001n);
  assert.ok(reader.chunkIndexes.length > 1);
  const late = await messagesOf(reader, {startTime: 29_000_000_000n});
  assert.equal(late.length, 1001);
  assert.ok(Math.abs(late[0].way - 29) < 1e-9);
});

test("every checksum of the file is right, from its beginning to its end", {skip: missing}, async () => {
  const {file} = await readerOf(diagram);
  const stream = new mcap.McapStreamReader({validateCrcs: true});
  stream.append(new Uint8Array(file));
  const kinds = new Map();
  for (let record = stream.nextRecord(); record; record = stream.nextRecord())
    kinds.set(record.type, (kinds.get(record.type) ?? 0) + 1);
  assert.ok(stream.done());
  assert.equal(kinds.get("Message"), 30001);
  assert.equal(kinds.get("Footer"), 1);
});

test("each run of a sweep is a channel with what it sets", {skip: missing}, async () => {
  const {reader} = await readerOf(`${diagram}sweep: {slope: {values: [1 m/s, 2 m/s]}}\n`.replace("30 s", "1 s"));
  const runs = [...reader.channelsById.values()].map((one) => [one.topic, one.metadata.get("slope")]);
  assert.deepEqual(runs, [["run-1", "1 m/s"], ["run-2", "2 m/s"]]);
  const [last] = (await messagesOf(reader, {topics: ["run-2"]})).slice(-1);
  assert.ok(Math.abs(last.way - 2) < 1e-9);
});
