package argo.recording

import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.Replay
import argo.recording.replay.WhatIf
import argo.recording.why.Question
import argo.recording.why.Why
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.architecture.MindInspectorWeb
import jdk.jfr.consumer.RecordingFile
import java.io.ByteArrayOutputStream
import java.io.ObjectOutputStream
import java.io.OutputStream
import java.net.ServerSocket
import java.nio.file.Path
import java.time.Duration
import java.util.Base64
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.zip.DeflaterOutputStream
import kotlin.concurrent.thread
import kotlin.io.path.createTempFile
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

object EndlessReplay {
    @JvmStatic
    fun main(arguments: Array<String>) = Recording(Path.of(arguments.single())).use { recording ->
        Replay(recording).use {
            println("replaying")
            it.run()
            Unit
        }
    }
}

/** Replaying an untrusted recording writes no file, reads none of the folder, opens no connection and starts no process. */
class HostileRecordingSpec : FunSpec({
    val folder = tempdir().toPath().toRealPath()
    val notes = folder.resolve("notes.asl").apply { writeText("mine") }
    val calls = AtomicInteger()
    val server = autoClose(ServerSocket(0))
    val address = "http://127.0.0.1:${server.localPort}/x.asl"
    beforeSpec {
        thread(isDaemon = true) {
            runCatching { while (true) server.accept().use { calls.incrementAndGet() } }
        }
    }

    /** Returns the files that this Java process reads and writes in [work], and the processes that it starts. */
    fun watched(work: () -> Unit): List<String> {
        val file = createTempFile("watch", ".jfr")
        val kinds = listOf("jdk.FileWrite", "jdk.FileRead", "jdk.ProcessStart", "jdk.SocketRead", "jdk.SocketWrite")
        try {
            jdk.jfr.Recording().use { watch ->
                kinds.forEach { watch.enable(it).withThreshold(Duration.ZERO) }
                watch.start()
                work()
                watch.stop()
                watch.dump(file)
            }
            return RecordingFile.readAllEvents(file).map { event ->
                "${event.eventType.name} ${if (event.hasField("path")) event.getString("path") else event}"
            }
        } finally {
            file.deleteExisting()
        }
    }

    fun replayed(file: Path): String? = try {
        Recording(file).use { recording -> Replay(recording).use { it.run().differences.joinToString() } }
    } catch (refused: RecordingException) {
        refused.message
    }

    fun shouldDoNothing(file: Path): String {
        var said: String? = null
        MindInspectorWeb.stop() // agents of another spec may have started it
        val done = watched { said = replayed(file) }
        val temporary = Path.of(System.getProperty("java.io.tmpdir")).resolve("argo-replay").toString()
        val (own, other) = done.filter { "jdk.FileRead" !in it }.partition { temporary in it }
        withClue(done.joinToString("\n")) {
            other.shouldBeEmpty()
            done.filter { "$folder" in it }.shouldBeEmpty()
            own.map { temporary + it.substringAfter(temporary).substringBefore('/') }.distinct().filter { Path.of(it).exists() }
                .shouldBeEmpty() // only the folder with the recorded programs
        }
        notes.readText() shouldBe "mine"
        folder.toFile().list().orEmpty().toList() shouldBe listOf("notes.asl")
        calls.get() shouldBe 0
        MindInspectorWeb.isRunning() shouldBe false
        return said.shouldNotBeNull()
    }

    fun started(step: String) = "!start. +!start <- $step; .print(done)."

    test("the watch sees what is written and read") {
        val written = createTempFile("seen")
        watched { written.writeText("x"); written.readText() }.map { it.substringBefore(' ') }.toSet() shouldBe
            setOf("jdk.FileWrite", "jdk.FileRead")
    }

    for (step in listOf(
        ".save_agent(\"NOTES\")", "jason.stdlib.save_agent(\"NOTES\")", ".stopMAS", ".create_agent(eve,\"NOTES\")", ".kill_agent(bob)",
        ".clone(\"eve\")", ".list_files(\"FOLDER\",L)", ".df_register(service)", ".include(\"NOTES\")", ".include(\"URL\")",
        ".term2string(A,\".save_agent(\\\"NOTES\\\")\"); A", ".add_plan({ +!x <- .save_agent(\"NOTES\") }); !x",
        "planted.file(X)", "planted.scratch(X)", ".term2string(A,\"planted.scratch(X)\"); A", "write(\"NOTES\")", ".send(eve,tell,hello)",
    )) {
        test("a step $step") {
            shouldDoNothing(made(started(step.replace("NOTES", "$notes").replace("FOLDER", "$folder").replace("URL", address))))
        }
    }

    for (program in listOf(
        "b({ SAVE }). !start. +!start <- ?b(X); X.", "b(SAVE). !start. +!start <- ?b(X); X.",
        "b(SAVE). !start. +!start <- ?b(X); .eval(Y,X).",
        "b(SAVE). !start. +!start : b(X) & X <- .print(a).", "b({ SAVE }) :- true. !start. +!start <- ?b(X); X.",
        "b[x({ SAVE })]. !start. +!start <- ?b[x(X)]; X.", "!start. +!start <- !x(Y); Y. +!x({ SAVE }).",
        "{ begin namespace(n) } b({ SAVE }). { end } !start. +!start <- ?n::b(X); X.",
        "{ begin namespace(n) } b[x({ SAVE })]. +!x({ SAVE }). { end } !start. +!start <- ?n::b[x(X)]; X; !n::x(Y); Y.",
    )) {
        test("what is kept elsewhere than in a step: $program") {
            shouldDoNothing(made(program.replace("SAVE", ".save_agent(\"$notes\")")))
        }
    }

    test("a belief that lists a folder") {
        val file = made("b({ .list_files(\"$folder\",L); +files(L) }). !start. +!start <- ?b(X); X; +listed. -!start <- +failed.")
        shouldDoNothing(file)
        val beliefs = Recording(file).use { recording -> Replay(recording).use { it.run().beliefs("bob") } }
        beliefs.filterNot { it.startsWith("b(") } shouldBe listOf("failed[source(self)]")
    }

    test("the project's own code in a belief") {
        val before = planted.calls.CALLS.get()
        shouldDoNothing(made("b(planted.calls(N)). !start. +!start <- ?b(X); X."))
        planted.calls.CALLS.get() shouldBe before
    }

    test("an included file of the computer, of another one, and of the class path") {
        val names = listOf("$notes", "../../../../../../../../../../$notes", "file:$notes", address, "ClassResource:/asl/kqmlPlans.asl")
        for (name in names) {
            shouldDoNothing(made("{ include(\"$name\") } !start.")) shouldContain "does not hold the file"
            shouldDoNothing(made("{ begin namespace(x) } { include(\"$name\") } { end } !start.")) shouldContain "does not hold the file"
        }
    }

    test("files inside that would stand elsewhere") {
        for (name in listOf("program/../../escaped.asl", "program/bob/../../../escaped.asl", "program/bob/\u0000")) {
            shouldDoNothing(made("!start.", files = mapOf(name to "x"))) shouldContain "has a file outside of its programs"
        }
        shouldDoNothing(made("!start.", mapOf("source" to "../notes.asl"), mapOf("../notes.asl" to "x"))) shouldContain
            "does not hold the program"
        shouldDoNothing(made("!start.", mapOf("source" to "$notes"))) shouldContain "does not hold the program"
    }

    test("classes that are no code of an agent, by every name that a recording can give") {
        val wanted = planted.Bomb::class.java.name
        shouldDoNothing(made(started("$wanted(X)"))) shouldContain
            "calls $wanted, a class that is neither an internal action nor a function"
        shouldDoNothing(made("{ begin namespace(x) } +!a : $wanted(1) <- .print(a). { end } !start.")) shouldContain "calls $wanted"
        shouldDoNothing(made("{ register_function(\"$wanted\") } !start.")) shouldContain "calls $wanted"
        shouldDoNothing(made(started(".term2string(A,\"$wanted(1)\"); A")))
        shouldDoNothing(made("!start.", mapOf("agentClass" to wanted))) shouldContain "agent bob had the class $wanted"
        shouldDoNothing(made("!start.", mapOf("beliefBase" to wanted))) shouldContain "agent bob had the class $wanted"
        shouldDoNothing(made("!start.", mapOf("archClass" to wanted))) shouldContain "agent bob had the architecture $wanted"
        shouldThrow<RecordingException> { replayOf(made("!start.", mapOf("archClass" to wanted)), isChecking = true) }.message shouldContain
            "which is not argo.Arch"
        planted.Bomb.explosions shouldBe 0
    }

    test("classes that the .mas2j names are not made, and refuse no recording") {
        val mas2j = "MAS x { agents: eve beliefBaseClass ${planted.Bomb::class.java.name}(7); bob; }"
        replayOf(made("!start. +!start <- .print(a).", files = mapOf("program/x.mas2j" to mas2j))).differences.shouldBeEmpty()
        planted.Bomb.explosions shouldBe 0
    }

    test("an architecture of the project, which is made with --check and for a program of the user's only") {
        val file = made("!start.", mapOf("archClass" to planted.Counted::class.java.name))
        shouldDoNothing(file) shouldContain "agent bob had the architecture planted.Counted; a class of the project may do anything"
        Recording(file).use { recording ->
            shouldThrow<RecordingException> { WhatIf(recording, "bob") }.message shouldContain "planted.Counted"
            Why(recording).use { why ->
                val question = checkNotNull(Question.of("stop"))
                shouldThrow<RecordingException> { why.not("bob", question) }.message shouldContain "planted.Counted"
            }
        }
        planted.Counted.made shouldBe 0
        replayOf(file, isChecking = true)
        Recording(file).use { recording -> WhatIf(recording, "bob", tempfile(suffix = ".asl").toPath()).use { it.run() } }
        planted.Counted.made shouldBe 2
    }

    test("an architecture of the project that no replay can make is told, with the remedy") {
        val file = made("!start.", mapOf("archClass" to planted.Plain::class.java.name))
        shouldThrow<RecordingException> { replayOf(file, isChecking = true) }.message shouldContain
            "add a constructor public Plain(argo.platform.Platform platform) { super(platform); }"
    }

    test("options that would begin a server or another recording") {
        val before = Thread.getAllStackTraces().keys.map { it.name }.toSet()
        val options = mapOf("option.argo_view" to "0", "option.argo_ros" to "127.0.0.1:9090", "option.argo_record" to "$folder/x.mcap")
        shouldDoNothing(made("!start.", options))
        val begun = Thread.getAllStackTraces().keys.map { it.name }.toSet() - before
        begun.filter { "argo" in it || "http" in it.lowercase() }.shouldBeEmpty()
    }

    fun keyFrame(write: (OutputStream) -> Unit): String {
        val bytes = ByteArrayOutputStream()
        DeflaterOutputStream(bytes).use(write)
        return """{"index":9,"number":9,"ns":9,"parts":PARTS,"mind":"${Base64.getEncoder().encodeToString(bytes.toByteArray())}"}"""
    }

    fun saidOf(keyFrame: String): String {
        val cycles = listOf("""{"index":10,"number":10,"ns":10}""")
        fun file(parts: String) = made("", keyFrame = keyFrame.replace("PARTS", parts), cycles = cycles)
        val parts = Regex("the program has (\\d+) plans").find(shouldDoNothing(file("0")))!!.groupValues[1]
        return shouldDoNothing(file(parts))
    }

    fun objectOf(one: Any) = keyFrame { ObjectOutputStream(it).use { stream -> stream.writeObject(one) } }

    test("key frames with objects of other classes") {
        saidOf(objectOf(java.io.File("x"))) shouldContain "cannot be read"
        saidOf(objectOf(arrayListOf(planted.Bomb()))) shouldContain "cannot be read"
        planted.Bomb.explosions shouldBe 1 // only the object that this test made
        planted.Bomb.explosions = 0
    }

    test("key frames that would fill the memory") {
        saidOf(keyFrame { it.write(ByteArray(200_000_000)) }) shouldContain "holds more than"
        val list = ByteArrayOutputStream()
        ObjectOutputStream(list).use { it.writeObject(ArrayList<Any>(0)) }
        // raises the number of objects, which the bytes contain twice
        val claims = list.toByteArray().also { bytes -> listOf(bytes.size - 11, bytes.size - 5).forEach { bytes[it] = 0x7F } }
        saidOf(keyFrame { it.write(claims) }) shouldContain "cannot be read"
        val deep = (1..20_000).fold(ArrayList<Any>()) { inner, _ -> arrayListOf(inner) }
        val written = ByteArrayOutputStream()
        Thread(null, { ObjectOutputStream(written).use { it.writeObject(deep) } }, "deep", 500_000_000L).apply { start(); join() }
        saidOf(keyFrame { it.write(written.toByteArray()) }) shouldContain "cannot be read"
    }

    test("messages that are not those of a recording") {
        val many = """{"index":1,"number":1,"ns":1,"input":{"percepts":{"take":2000000000}}}"""
        for (cycle in listOf("[", "{}", many, """{"index":"x"}""")) {
            shouldDoNothing(made("!start.", cycles = listOf(cycle))) shouldContain "a message of /bob/cycle cannot be read"
        }
        val deep = "f(".repeat(100_000) + ")".repeat(100_000)
        val mail = """{"index":1,"number":1,"ns":1,"input":{"mail":[{"performative":"tell","sender":"eve","content":"$deep","id":"m"}]}}"""
        shouldDoNothing(made("!start.", cycles = listOf(mail)))
    }

    test("texts that are none") {
        val events = """{"index":1,"number":1,"ns":1,"input":{"events":["+((("]}}"""
        shouldDoNothing(made("!start.", cycles = listOf(events))) shouldContain "cannot be read"
        for (beginning in listOf("""{"beliefs":["((("]}""", """{"events":["((("]}""")) {
            shouldDoNothing(made("!start.", mapOf("beginning" to beginning))) shouldContain "cannot be read"
        }
    }

    test("a context that is searched for ever, until Java is ended: then the folder of the replay is removed, too") {
        val file = made("!start. +!start : .range(I,0,2000000000) & I < 0 <- .print(a).")
        val folders = tempdir()
        val java = ProcessHandle.current().info().command().get()
        val process = ProcessBuilder(
            java, "-Djava.io.tmpdir=$folders", "-cp", System.getProperty("java.class.path"), EndlessReplay::class.java.name, "$file",
        ).redirectErrorStream(true).start()
        process.inputReader().use { it.readLine() shouldBe "replaying" }
        folders.list().orEmpty().filter { it.startsWith("argo-replay") } shouldHaveSize 1
        process.destroy()
        process.waitFor(1, TimeUnit.MINUTES) shouldBe true
        folders.list().orEmpty().toList().shouldBeEmpty()
    }

    test("a rule without an end") {
        shouldDoNothing(made("loop :- loop. !start. +!start : loop <- .print(a).")) shouldContain "nested too deeply"
    }
})
