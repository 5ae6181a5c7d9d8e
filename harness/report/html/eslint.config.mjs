// Run by ci/lint, which names the folder that the packages are installed in.
import { createRequire } from "node:module";

const require = createRequire(`${process.env.FILLRULE_NODE_FOLDER}/`);
const js = require("@eslint/js");
const globals = require("globals");

const rules = {
  ...js.configs.recommended.rules,
  curly: ["error", "multi-line"],
  eqeqeq: "error",
  "no-var": "error",
  "prefer-const": "error",
  "no-shadow": "error",
  "max-lines": ["error", 300],
  "max-lines-per-function": ["error", 60],
};

export default [
  { files: ["*.js"], languageOptions: { globals: globals.browser }, rules },
  { files: ["test/*.mjs"], languageOptions: { globals: { ...globals.node, ...globals.browser } }, rules },
];
