// `stepwire lsp` as an editor meets it: over its pipes, with a client of npm.

import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {writeFileSync} from "node:fs";
import {after, before, test} from "node:test";
import {Editor, between, edited, missing, place} from "./editor.mjs";

const options = {skip: missing, timeout: 60_000};
const head = "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 1 s\nsolver: rk4\n";
let editor;
before(async () => { if (!missing) editor = await Editor.started(); });
after(async () => { if (editor) assert.equal(await editor.gone(), 0); });

test("what is wrong has its range in the text, and its quick fix gives a file that checks", options, async () => {
  const text = head + "record: [lag]\nblocks:\n  one: {block: Constant, value: 1}\n  lag: {block: Lag, u: oen, tau: 0.1 s}\n";
  await editor.open("broken.yaml", text);
  const [wrong] = await editor.diagnostics("broken.yaml", (all) => all.length === 1);
  assert.equal(between(text, wrong.range), "oen");
  assert.match(wrong.message, /there is no block 'oen'; did you mean 'one'\?/);
  const actions = await editor.ask("textDocument/codeAction",
    {textDocument: {uri: editor.uri("broken.yaml")}, range: wrong.range, context: {diagnostics: [wrong]}});
  assert.deepEqual(actions.map((one) => one.title), ["change to 'one'"]);
  const mended = edited(text, actions[0].edit.changes[editor.uri("broken.yaml")]);
  assert.ok(mended.includes("u: one,"));
  writeFileSync(editor.path("mended.yaml"), mended);
  const {status, stderr} = spawnSync(process.env.STEPWIRE_PROGRAM, ["check", editor.path("mended.yaml")]);
  assert.equal(status, 0, String(stderr));
  await editor.change("broken.yaml", [{text: mended}]);
  await editor.diagnostics("broken.yaml", (all) => all.length === 0);
});

test("columns are units of UTF-16 behind an emoji, a tab and an Ω, in ranges and in changes", options, async () => {
  const text = head + "record: [r]\nblocks:\n  r: {block: Gain, gain: 2,\t\"u\": 'x😀Ω'}  # 😀\n  # Ω😀\n";
  await editor.open("columns.yaml", text);
  const [wrong] = await editor.diagnostics("columns.yaml", (all) => all.length === 1);
  assert.equal(between(text, wrong.range), "'x😀Ω'");
  const start = place(text, "😀Ω'"), end = place(text, "😀Ω'", 3);
  await editor.change("columns.yaml", [{range: {start, end}, text: "yΩ"}]);
  const [other] = await editor.diagnostics("columns.yaml", (all) => all.some((one) => one.message.includes("xyΩ")));
  assert.equal(between(editor.texts.get("columns.yaml"), other.range), "'xyΩ'");
});

test("outputs whose unit fits an input come first, and parameters of that unit are offered", options, async () => {
  const text = head + "parameters: {spring: 2 N/m, weight: 3 N}\nrecord: [body.position]\nblocks:\n" +
    "  far: {block: Constant, value: 1 m}\n  a_push: {block: Constant, value: $weight}\n" +
    "  body: {block: Mass, mass: 1 kg, force: a_push}\n";
  await editor.open("units.yaml", text);
  await editor.diagnostics("units.yaml", () => true);
  const at = place(text, "force: a_push", "force: ".length);
  const {items} = await editor.ask("textDocument/completion", editor.at("units.yaml", at));
  const sorted = [...items].sort((a, b) => (a.sortText < b.sortText ? -1 : 1)).map((one) => one.label);
  assert.ok(sorted.indexOf("a_push") >= 0 && sorted.indexOf("a_push") < sorted.indexOf("far"), sorted.join());
  assert.ok(sorted.indexOf("$weight") < sorted.indexOf("$spring"), sorted.join());
});

test("completion goes on while the text is no YAML yet", options, async () => {
  const text = head + "record: all\nblocks:\n  one: {block: Constant, value: 1}\n  lag: {block: La";
  await editor.open("typing.yaml", text);
  const end = place(text, "La", 2);
  const types = await editor.ask("textDocument/completion", editor.at("typing.yaml", end));
  const lag = types.items.find((one) => one.label === "Lag");
  assert.ok(lag && lag.documentation.value.length > 10);
  const more = text + "g, u: one, ";
  await editor.change("typing.yaml", [{text: more}]);
  const keys = await editor.ask("textDocument/completion", editor.at("typing.yaml", place(more, "one, ", 5)));
  assert.ok(keys.items.some((one) => one.label === "tau"));
  assert.ok(!keys.items.some((one) => one.label === "u"));
});

test("a rename goes over all files that have the name, and these check as before", options, async () => {
  const part = "stepwire: 1\ntitle: a spring\ninputs: {x: {unit: m}}\noutputs: {force: k}\nparameters: {c: 2 N/m}\n" +
    "blocks:\n  k: {block: Gain, gain: $c, u: x}\n";
  const user = head + "record: [rig.k, rig.force]\nclaims: [{that: k is small, max: abs(rig.k), at_most: 3 N}]\n" +
    "blocks:\n  far: {block: Constant, value: 1 m}\n  rig: {diagram: spring.yaml, x: far, c: 1 N/m}\n";
  editor.file("user.yaml", user);
  await editor.open("spring.yaml", part);
  const at = editor.at("spring.yaml", place(part, "  k: {", 2));
  assert.equal(between(part, await editor.ask("textDocument/prepareRename", at)), "k");
  const {changes} = await editor.ask("textDocument/rename", {...at, newName: "stiffness"});
  const after = edited(user, changes[editor.uri("user.yaml")]);
  assert.ok(after.includes("record: [rig.stiffness, rig.force]") && after.includes("abs(rig.stiffness)"));
  assert.ok(after.includes("that: k is small"));
  const inside = edited(part, changes[editor.uri("spring.yaml")]);
  assert.ok(inside.includes("force: stiffness}") && inside.includes("  stiffness: {block"));
  const parameter = await editor.ask("textDocument/rename", {...editor.at("spring.yaml", place(part, "$c", 1)), newName: "rate"});
  assert.ok(edited(part, parameter.changes[editor.uri("spring.yaml")]).includes("{rate: 2 N/m}"));
  assert.ok(edited(user, parameter.changes[editor.uri("user.yaml")]).includes("rate: 1 N/m}"));
  await assert.rejects(editor.ask("textDocument/rename", {...at, newName: "no name"}), /is no name/);
  await assert.rejects(editor.ask("textDocument/rename", {...at, newName: "x"}), /there is a 'x' already/);
});

test("a fault in a part is shown in the part, and where it is used", options, async () => {
  editor.file("bad.yaml", "stepwire: 1\ntitle: p\ninputs: {x: }\noutputs: {y: k}\nblocks:\n  k: {block: Gain, gian: 2, u: x}\n");
  const user = head + "record: [rig]\nblocks:\n  one: {block: Constant, value: 1}\n  rig: {diagram: bad.yaml, x: one}\n";
  await editor.open("uses.yaml", user);
  const [used] = await editor.diagnostics("uses.yaml", (all) => all.length > 0);
  assert.equal(between(user, used.range), "bad.yaml");
  assert.match(used.message, /in bad.yaml: .*Gain has no 'gian'/);
  const [own] = await editor.diagnostics("bad.yaml", (all) => all.length > 0);
  assert.equal(between(editor.texts.get("bad.yaml"), own.range), "gian");
});

test("hover, definition, references and the outline know the names of a file", options, async () => {
  const text = head + "parameters: {tau: {value: 20 ms, doc: how slow it is}}\nrecord: [lag]\nblocks:\n" +
    "  one: {block: Constant, value: 1 N}\n  lag: {block: Lag, u: one, tau: $tau}\n";
  await editor.open("names.yaml", text);
  const at = (word, behind) => editor.at("names.yaml", place(text, word, behind));
  const hover = async (word, behind = 0) => (await editor.ask("textDocument/hover", at(word, behind))).contents.value;
  assert.match(await hover("Lag"), /^# Lag/);
  assert.match(await hover("$tau", 1), /20 ms.*how slow it is/s);
  assert.match(await hover("u: one", 3), /in N/);
  assert.match(await hover("solver"), /continuous states/);
  const definition = await editor.ask("textDocument/definition", at("u: one", 4));
  assert.equal(between(text, definition.range), "one");
  assert.equal(definition.range.start.line, place(text, "one: {").line);
  const uses = await editor.ask("textDocument/references", {...at("  lag: {", 3), context: {includeDeclaration: true}});
  assert.equal(uses.length, 2);
  const outline = await editor.ask("textDocument/documentSymbol", {textDocument: {uri: editor.uri("names.yaml")}});
  const blocks = outline.find((one) => one.name === "blocks");
  assert.deepEqual(blocks.children.map((one) => [one.name, one.detail]), [["one", "Constant"], ["lag", "Lag"]]);
});

test("of several changes at once the last one counts, and what nobody knows is answered", options, async () => {
  const good = head + "record: [one]\nblocks:\n  one: {block: Constant, value: 1}\n";
  await editor.open("fast.yaml", good);
  for (let i = 0; i < 50; ++i) await editor.change("fast.yaml", [{text: good.replace("Constant", "C".repeat(i + 1))}]);
  await editor.change("fast.yaml", [{text: good}]);
  assert.deepEqual(await editor.diagnostics("fast.yaml"), []);
  await assert.rejects(editor.ask("textDocument/foldingRange", {}), /there is no method/);
  await assert.rejects(editor.ask("textDocument/hover", {}), /'position' is missing/);
});

test("what is no message gives one sentence, and no crash", {timeout: 60_000}, () => {
  const run = (input) => spawnSync(process.env.STEPWIRE_PROGRAM, ["lsp"], {input});
  const framed = (body) => `Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`;
  for (const input of ["hello\r\n\r\n", "Content-Length: 99999999999\r\n\r\n", "Content-Length: 10\r\n\r\nxx", "x".repeat(9000)]) {
    const {status, stderr} = run(input);
    assert.equal(status, 1);
    assert.equal(String(stderr).trim().split("\n").length, 1, String(stderr));
  }
  for (const body of ["{", "[]", "3", "null", "{\"id\": 1}", "{\"id\": 1, \"method\": 2}", "[".repeat(100_000), "{\"id\": 1, \"method\": \"x\"}"]) {
    const {status, stdout} = run(framed(body));
    assert.equal(status, 1, body.slice(0, 40));
    if (body !== "{\"id\": 1}") assert.match(String(stdout), /"error"/, body.slice(0, 40));
  }
});
