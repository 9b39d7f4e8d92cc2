// Prints what the reader of npm's @mcap/core finds in a file: node read.mjs whole|cut FILE MODULES
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [how, file, modules] = process.argv.slice(2);
const require = createRequire(`${modules}/`);
const { McapIndexedReader, McapStreamReader } = require("@mcap/core");
const lz4 = require("lz4js");
const decompressHandlers = { lz4: (data, size) => lz4.decompress(data, Number(size)) };
const bytes = new Uint8Array(readFileSync(file));
const text = (data) => new TextDecoder().decode(data);
const line = (topic, message) => console.log(`${topic} ${message.sequence} ${message.logTime} ${text(message.data)}`);
const attachment = (of) => console.log(`attachment ${of.name} ${of.mediaType} ${text(of.data)}`);
const metadata = (of) => console.log(`metadata ${of.name} ${[...of.metadata.values()][0]}`);

// Reads the file by the index at its end.
async function whole() {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (at, length) => bytes.slice(Number(at), Number(at + length)),
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  for await (const message of reader.readMessages()) line(reader.channelsById.get(message.channelId).topic, message);
  for await (const of of reader.readAttachments()) attachment(of);
  for await (const of of reader.readMetadata()) metadata(of);
  console.log(`count ${reader.statistics.messageCount}`);
}

// Reads the file from its beginning, as far as it is complete.
function cut() {
  const reader = new McapStreamReader({ validateCrcs: true, decompressHandlers });
  const topics = new Map();
  reader.append(bytes);
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === "Channel") topics.set(record.id, record.topic);
    if (record.type === "Message") line(topics.get(record.channelId), record);
    if (record.type === "Attachment") attachment(record);
    if (record.type === "Metadata") metadata(record);
  }
}

await { whole, cut }[how]();
