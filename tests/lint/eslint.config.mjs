// Rules for TypeScript and JavaScript, those of eslint and typescript-eslint besides. Prettier is not used: it breaks tables, lists of
// constants and short handlers into four lines each.
import js from "@eslint/js";
import stylistic from "@stylistic/eslint-plugin";
import ts from "typescript-eslint";

const form = {
  "@stylistic/arrow-parens": "error",
  "@stylistic/arrow-spacing": "error",
  "@stylistic/block-spacing": "error",
  "@stylistic/brace-style": ["error", "1tbs", {allowSingleLine: true}],
  "@stylistic/comma-spacing": "error",
  "@stylistic/eol-last": "error",
  "@stylistic/key-spacing": "error",
  "@stylistic/keyword-spacing": "error",
  "@stylistic/no-tabs": "error",
  "@stylistic/no-trailing-spaces": "error",
  "@stylistic/quotes": ["error", "double", {avoidEscape: true, allowTemplateLiterals: "always"}],
  "@stylistic/semi": "error",
  "@stylistic/space-before-blocks": "error",
  "@stylistic/space-infix-ops": "error",
  "@stylistic/type-annotation-spacing": "error",
};

export default ts.config(
  {ignores: ["**/node_modules/**", "build*/**", "out/**"]},
  js.configs.recommended,
  ...ts.configs.recommended,
  {
    plugins: {"@stylistic": stylistic},
    rules: {
      ...form,
      "eqeqeq": ["error", "always", {null: "ignore"}],
      "no-undef": "off",  // the compiler finds these
      "no-var": "error",
      "prefer-const": "error",
      "@typescript-eslint/no-explicit-any": "off",
      "@typescript-eslint/no-unused-expressions": ["error", {allowTernary: true}],
      "@typescript-eslint/no-unused-vars": ["error", {argsIgnorePattern: "^_", varsIgnorePattern: "^_"}],
    },
  },
  {
    // The only warning. tests/lint/run allows as many as there are, and no more: two dispatch tables and two functions.
    files: ["engine/**/*.{ts,mjs}"],
    rules: {"max-lines-per-function": ["warn", {max: 27}]},  // with the lines of its head and its last brace
  },
  {
    files: ["engine/app/studio/page/src/**/*.ts"],
    languageOptions: {parserOptions: {project: "engine/app/studio/page/tsconfig.json", tsconfigRootDir: process.cwd()}},
    rules: {
      "@typescript-eslint/no-floating-promises": "error",
      "@typescript-eslint/no-misused-promises": ["error", {checksVoidReturn: {arguments: false}}],
    },
  },
);
