// Each line of the input is a JSON document. Prints for each line what the schema in a file refuses, or "ok".
// node schema.mjs FOLDER SCHEMA
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const [folder, schema] = process.argv.slice(2);
const Ajv = createRequire(join(folder, "package.json"))("ajv");
const ajv = new Ajv({ strict: false });
const validate = ajv.compile(JSON.parse(readFileSync(schema, "utf8")));
for (const line of readFileSync(0, "utf8").trimEnd().split("\n")) {
  console.log(validate(JSON.parse(line)) ? "ok" : ajv.errorsText(validate.errors));
}
