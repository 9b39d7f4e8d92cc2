package samples.firmware

import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.exists
import kotlin.io.path.isExecutable
import kotlin.io.path.writeText

class BoardCommandSpec : FunSpec({
    val folder = tempdir().toPath()
    val sketch = folder.resolve("my wall").createDirectory().resolve("wall.ino").apply { writeText(SKETCH) }
    val link = folder.resolve("ttyUNO")
    val compiles: EnabledOrReasonIf = { ifUnoCanBeSimulated() }
    val drawn: EnabledOrReasonIf = {
        if (!onPath("socat")) Enabled.disabled("there is no socat for a terminal") else compiles(it)
    }

    test("inputs are set by lines, outputs are shown as lines, and the tools reach the board").config(
        tags = thorough,
        enabledOrReasonIf = compiles,
    ) {
        Console("bash", "../argo", "board", "$sketch", "--link", "$link").use { board ->
            board.await("port $link\n")
            board.await("argo.port(\"$link\")")
            board.type("A0=512 7=1 8=30cm")
            board.await("8 in 30cm")
            board.await("A0 in 512")
            tool("ports", "--describe", "$link") shouldContain "actions: ledOn, speed/1"
            tool("request", "$link", "getPercepts") shouldBe "light(512);button(1);dist(front,30);\n"
            board.type("A0=1023 7=0 8=0cm")
            board.await("7 in low")
            board.await("A0 in 1023")
            tool("request", "$link", "getPercepts") shouldBe "light(1023);button(0);dist(front,0);\n"
            tool("send", "$link", "speed(120)")
            board.await("5 out PWM 120")
            board.type("20=1 3=7 8=999cm A0=1024 nonsense")
            board.await("20=1: there is no such pin")
            board.await("3=7: a level is 0 or 1")
            board.await("8=999cm: an HC-SR04 measures up to 400 cm")
            board.await("A0=1024: an analogue value is from 0 to 1023")
            board.await("set inputs: 7=1 a level")
            Console("bash", "../argo", "board", "$sketch", "--link", "$link").use { other ->
                other.await("$link exists already, maybe as the port of another simulated board")
                other.status() shouldBe 1
            }
            tool("request", "$link", "getPercepts") shouldBe "light(1023);button(0);dist(front,0);\n"
            board.type("quit")
            board.status() shouldBe 0
        }
        link.exists() shouldBe false
    }

    test("on a terminal the pins are one line that is redrawn, with what is typed").config(tags = thorough, enabledOrReasonIf = drawn) {
        val command = "bash ../argo board \"$sketch\" --link $link"
        Console("socat", "-t5", "STDIO", "SYSTEM:'$command',pty,setsid,ctty,stderr").use { board ->
            board.await("\r\u001B[K")
            board.await("13 out low")
            board.type("A0=77x\u007F", end = "")
            board.await("> A0=77")
            board.type("")
            board.await("A0 in 77 ")
            board.type("quit")
            board.status() shouldBe 0
        }
    }

    test("a sketch with an error is refused with the compiler's words and its own line").config(
        tags = thorough,
        enabledOrReasonIf = compiles,
    ) {
        val wrong = folder.resolve("wrong.ino").apply { writeText("void setup() {\n  nothing();\n}\nvoid loop() {}\n") }
        Console("bash", "../argo", "board", "$wrong").use { board ->
            board.await("wrong.ino:2:")
            board.await("does not compile for the Uno")
            board.status() shouldBe 1
        }
    }

    test("a sketch that names the library's header in lower case is told how it is written").config(
        tags = thorough,
        enabledOrReasonIf = compiles,
    ) {
        val wrong = folder.resolve("lower.ino").apply { writeText("#include <javino.h>\nvoid setup() {}\nvoid loop() {}\n") }
        Console("bash", "../argo", "board", "$wrong").use { board ->
            board.await("the header of the library is <Javino.h>")
            board.status() shouldBe 1
        }
    }

    test("a sketch for another board is told what the simulated one has").config(tags = thorough, enabledOrReasonIf = compiles) {
        Console("bash", "../argo", "board", "../javino-arduino/examples/ServoArm").use { board ->
            board.await("Servo.h")
            board.await("of libraries Javino and SoftwareSerial")
            board.status() shouldBe 1
        }
    }

    test("a machine without the AVR tools is told the packages") {
        val few = folder.resolve("few").createDirectory()
        listOf("bash", "dirname", "uname", "basename").forEach { name ->
            few.resolve(name).createSymbolicLinkPointingTo(onPathOrNull(name) ?: error("no $name"))
        }
        val board = Console("bash", "../argo", "board", "$sketch") { it["PATH"] = "$few"; it["ARDUINO_AVR"] = "/nowhere" }
        board.use {
            it.await("sudo apt install make gcc gcc-avr avr-libc arduino-core-avr libsimavr-dev libelf-dev")
            it.status() shouldBe 1
        }
    }

    test("no sketch, two of them and a missing one are refused") {
        Console("bash", "../argo", "board").use { it.await("board takes a sketch, such as"); it.status() shouldBe 2 }
        Console("bash", "../argo", "board", "a.ino", "b.ino").use { it.await("not also: b.ino"); it.status() shouldBe 2 }
        Console("bash", "../argo", "board", "none.ino").use { it.await("there is no sketch none.ino"); it.status() shouldBe 1 }
        Console("bash", "../argo", "board", "pom.xml").use { it.await("a file that ends in .ino"); it.status() shouldBe 1 }
    }
})

private val SKETCH = """
    #include <Javino.h>

    Javino javino;
    bool speed(const JavinoArguments &arguments) {
      analogWrite(5, (int)arguments.number(0));
      return true;
    }
    void ledOn() { digitalWrite(13, HIGH); }
    void look() {
      digitalWrite(9, HIGH);
      delayMicroseconds(10);
      digitalWrite(9, LOW);
      int cm = (pulseIn(8, HIGH, 30000) + 29) / 58;
      javino.percept("light", analogRead(A0));
      javino.percept("button", digitalRead(7));
      javino.percept("dist", "front", cm);
    }

    void setup() {
      pinMode(13, OUTPUT);
      pinMode(7, INPUT_PULLUP);
      pinMode(9, OUTPUT);
      javino.act["ledOn"] = ledOn;
      javino.onAction("speed", speed, 1);
      javino.perceive(look);
      javino.start(9600);
    }

    void loop() { javino.run(); }
""".trimIndent() + "\n"

private val thorough = setOf(NamedTag("Thorough"))
