// Builds the page into dist/: one page, one style sheet, and scripts with fixed names, as the program contains them in a table.

import {fileURLToPath} from "node:url";
import {defineConfig} from "vite";
import {licences} from "./src/gallery/licences.mjs";

const named = "assets/[name][extname]", here = fileURLToPath(new URL(".", import.meta.url));

export default defineConfig({
  root: here,
  base: "/",
  plugins: [licences(here)],
  // The drawing's modules are in the engine, beside the page; elkjs is resolved from the page.
  server: {fs: {allow: [fileURLToPath(new URL("../../../..", import.meta.url))]}},
  build: {
    target: "es2022",
    minify: "terser",  // 3 % smaller than with esbuild
    outDir: "dist",
    emptyOutDir: true,
    assetsInlineLimit: 0,  // the page's security policy refuses styles and scripts in data: URLs
    cssCodeSplit: false,
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    rollupOptions: {
      // Scripts of a few hundred characters are merged into those that load them.
      output: {entryFileNames: "assets/[name].js", chunkFileNames: "assets/[name].js", assetFileNames: named, experimentalMinChunkSize: 4000},
    },
  },
  worker: {format: "es", rollupOptions: {output: {entryFileNames: "assets/[name].js", assetFileNames: named}}},
});
