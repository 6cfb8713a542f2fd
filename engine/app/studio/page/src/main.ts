import {connect, Fault} from "./connection/connection";
import {DrawingView} from "./drawing/drawing_view";
import {menuEntries} from "./gallery/menu";
import {followTexts} from "./run/loaded_texts";
import {RunBar} from "./run/run_bar";
import {RunModel} from "./run/run_model";
import {Bar} from "./shell/bar";
import type {Context} from "./shell/context";
import {Layout, type Pane} from "./shell/layout";
import {Notices} from "./shell/notices";
import {Settings} from "./shell/settings";
import {Shortcuts} from "./shell/shortcuts";
import {type Choice, Theme} from "./shell/theme";
import {serveRequests} from "./text/requests";
import {TextView} from "./text/text_view";
import {Workbench} from "./text/workbench";
import "./shell/tokens.css";
import "./shell/shell.css";

const connection = connect(), notices = new Notices(), settings = new Settings(connection);
const notify = (text: string, kind?: "note" | "fault") => notices.notify(text, kind);
const context: Context = {
  connection, settings, notify, run: new RunModel(connection), shortcuts: new Shortcuts(), theme: new Theme(), workbench: new Workbench(connection, notify),
  announce: (text) => notices.announce(text), show: (pane) => layout.show(pane, true),
};
const panes: Pane[] = [
  {id: "text", title: "Text", make: async (host) => new TextView(host, context)},
  {id: "drawing", title: "Drawing", make: async (host) => new DrawingView(host, context)},
  {id: "scopes", title: "Scopes", make: async (host) => new (await import("./scopes/scope_board")).ScopeBoard(host, context)},
  {id: "scene", title: "Scene", make: async (host) => new (await import("./scene/scene_view")).SceneView(host, context)},
  {id: "mechanism", title: "3-D", make: async (host) => new (await import("./scene/mechanism_view")).MechanismView(host, context)},
  {id: "figures", title: "Figures", make: async (host) => new (await import("./figures/figures_view")).FiguresView(host, context)},
  {id: "loop", title: "Loop", isKept: true, make: async (host) => new (await import("./loop/loop_view")).LoopView(host, context)},
  {id: "tuning", title: "Tuning", make: async (host) => new (await import("./tuning/tuning_list")).TuningList(host, context)},
];
const bar = new Bar(context), layout = new Layout(panes, settings);
document.body.append(bar.element, layout.element, notices.element);
bar.entries.push(...menuEntries(context));
new RunBar(bar.run, context);

const addDigit = ({id, title}: Pane, i: number) => context.shortcuts.add({key: String(i + 1), text: title.toLowerCase(), group: "Panes", action: () => layout.show(id, true)});
panes.forEach((pane, i) => { if (!pane.isKept) addDigit(pane, i); });
context.shortcuts.add({key: "F6", text: "next pane", group: "Panes", action: () => layout.cycle(1)});
context.shortcuts.add({key: "Shift+F6", text: "previous pane", group: "Panes", action: () => layout.cycle(-1)});
settings.on((key) => { if (key === "theme") context.theme.choose(settings.get<Choice>("theme", "system")); });

/** Loads the diagram for a run. A diagram with faults is loaded when its run is started. */
async function load(file: number): Promise<void> {
  try {
    await context.run.load(file);
  } catch {
    context.run.file = file;
    context.run.markStale();
  }
}

serveRequests(context);
context.workbench.on("root", (file) => void load(file));
followTexts(context);
context.workbench.on("faults", ({faults}) => { if (faults.length === 0 && !context.run.loaded && context.run.file !== null) void load(context.workbench.root); });

let isStarted = false;
connection.on("connection", async ({state, hello, fault}) => {
  if (fault) notify(`the studio refuses the page: ${fault.message}`, "fault");
  if (state !== "open" || isStarted) return;
  isStarted = true;
  try {
    await settings.load();
    if (hello.loop) {
      layout.offer("loop");
      panes.forEach((pane, i) => { if (pane.isKept) addDigit(pane, i); });
    }
    await context.workbench.start(hello.file);
    const {tourOnFirstVisit} = await import("./tour/tour");
    await tourOnFirstVisit(context);
  } catch (thrown) {
    notify(Fault.from(thrown).message, "fault");
  }
});
