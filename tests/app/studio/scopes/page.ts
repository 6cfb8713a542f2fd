// Run bar, scopes and tuning alone, on a simulated server: for inspection, and for measuring the cost of a picture.

import "../../../../engine/app/studio/page/src/shell/tokens.css";
import "../../../../engine/app/studio/page/src/shell/shell.css";
import {RunBar} from "../../../../engine/app/studio/page/src/run/run_bar";
import {RunModel} from "../../../../engine/app/studio/page/src/run/run_model";
import {ScopeBoard} from "../../../../engine/app/studio/page/src/scopes/scope_board";
import type {Context} from "../../../../engine/app/studio/page/src/shell/context";
import {Notices} from "../../../../engine/app/studio/page/src/shell/notices";
import {Settings} from "../../../../engine/app/studio/page/src/shell/settings";
import {Shortcuts} from "../../../../engine/app/studio/page/src/shell/shortcuts";
import {Theme} from "../../../../engine/app/studio/page/src/shell/theme";
import {TuningList} from "../../../../engine/app/studio/page/src/tuning/tuning_list";
import {FakeConnection} from "./fake_connection";

const given = Object.fromEntries(new URLSearchParams(location.search));
const number = (name: string, otherwise: number) => Number(given[name] ?? otherwise);
const shape = {signals: number("signals", 12), scopes: number("scopes", 2), perScope: number("per", 3), step: 0.001, seconds: number("seconds", 120)};
const connection = new FakeConnection(shape), notices = new Notices(), settings = new Settings(connection);
const context: Context = {
  connection, settings, run: new RunModel(connection), shortcuts: new Shortcuts(), theme: new Theme(), workbench: {nameOf: () => "cart.yaml"} as never,
  notify: (text, kind) => notices.notify(text, kind), announce: (text) => notices.announce(text), show: () => {},
};
const place = (name: string) => document.body.appendChild(Object.assign(document.createElement("div"), {className: name}));
await settings.load();
const bar = new RunBar(place("bar"), context), board = new ScopeBoard(place("view"), context), tuning = new TuningList(place("tune"), context);
document.body.append(notices.element);
await context.run.load(1);
Object.assign(window, {studio: {context, bar, board, tuning}});
