// Builds the page into dist/: one page, one style sheet, and scripts with fixed names, so that the program can hold them as a table.

import {fileURLToPath} from "node:url";
import {defineConfig} from "vite";
import {licences} from "./src/gallery/licences.mjs";

const named = "assets/[name][extname]", here = fileURLToPath(new URL(".", import.meta.url));

export default defineConfig({
  root: here,
  base: "/",
  plugins: [licences(here)],
  // The drawing's own modules lie beside the page in the engine; elkjs is resolved from the page.
  server: {fs: {allow: [fileURLToPath(new URL("../../../..", import.meta.url))]}},
  build: {
    target: "es2022",
    minify: "terser",  // 3 % smaller than with esbuild
    outDir: "dist",
    emptyOutDir: true,
    assetsInlineLimit: 0,  // data: addresses of styles and scripts are refused by the page's security policy
    cssCodeSplit: false,
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    rollupOptions: {
      // Scripts of a few hundred letters go into those that load them.
      output: {entryFileNames: "assets/[name].js", chunkFileNames: "assets/[name].js", assetFileNames: named, experimentalMinChunkSize: 4000},
    },
  },
  worker: {format: "es", rollupOptions: {output: {entryFileNames: "assets/[name].js", assetFileNames: named}}},
});
