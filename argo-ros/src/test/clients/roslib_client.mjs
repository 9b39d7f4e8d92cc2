// A client of roslib: reads a board's messages, has it act, and prints all that it saw as JSON.
//
//     node roslib_client.mjs NODE_MODULES PORT MESSAGES

import { pathToFileURL } from "node:url";

const [modules, port, wanted] = process.argv.slice(2);
const ROSLIB = await import(pathToFileURL(`${modules}/roslib/dist/RosLib.js`));

const seen = {};
const ros = new ROSLIB.Ros();
ros.on("error", (trouble) => console.error("error", trouble?.message ?? trouble));
await new Promise((connected) => {
  ros.on("connection", connected);
  ros.connect(`ws://127.0.0.1:${port}`);
});

seen.topics = (await new Promise((done, failed) => ros.getTopics(done, failed))).topics.sort();

const counts = [];
const topic = new ROSLIB.Topic({ ros, name: "/uno/count", messageType: "std_msgs/Float64", throttle_rate: 20, queue_length: 1 });
const enough = new Promise((done) => {
  topic.subscribe((message) => {
    counts.push(message.data);
    if (counts.length === Number(wanted)) done(true);
  });
});

const service = new ROSLIB.Service({ ros, name: "/uno/blink", serviceType: "argo_msgs/Command" });
seen.service = await new Promise((done, failed) => service.callService({ arguments: [1] }, done, failed));

const action = new ROSLIB.Action({ ros, name: "/uno/blink", actionType: "argo_msgs/action/Command" });
seen.action = await new Promise((done) => action.sendGoal({ arguments: [2] }, done, undefined, done));

const old = new ROSLIB.ActionClient({ ros, serverName: "/uno/blink", actionName: "argo_msgs/CommandAction", timeout: 60000 });
const goal = new ROSLIB.Goal({ actionClient: old, goalMessage: { arguments: [3] } });
seen.oldAction = await new Promise((done) => {
  goal.on("result", done);
  goal.send();
});

const publisher = new ROSLIB.Topic({ ros, name: "/uno/blink/command", messageType: "std_msgs/Int32" });
publisher.publish({ data: 4 });

seen.enough = await enough;
seen.increasing = counts.every((count, index) => index === 0 || counts[index - 1] < count);
console.log(JSON.stringify(seen));
ros.close();
process.exit(0);
