package argo.tools

import argo.tools.samples.SampleProgramCommand
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldBeEmpty
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith
import picocli.CommandLine
import java.io.IOException
import java.io.OutputStream
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import kotlin.io.path.readText

class CommandLineSpec : FunSpec({
    fun all(command: CommandLine): List<CommandLine> = listOf(command) + command.subcommands.values.flatMap(::all)

    test("every command has help, says what it does, and has an exit status of 0 for that") {
        val own = all(tools()).filterNot { it.commandSpec.userObject() is SampleProgramCommand } // the samples print their own help
        own.map { it.commandSpec.qualifiedName(" ").split(' ').drop(1) }.forEach { words ->
            val said = argo(*words.toTypedArray(), "--help")
            withClue("argo $words\n$said") {
                said.status shouldBe 0
                said.out shouldStartWith "Usage: argo ${words.joinToString(" ")}".trim()
                said.err.shouldBeEmpty()
            }
        }
    }

    context("wrong arguments are refused with a reason and exit status 2") {
        listOf(
            "" to "name a command: ports, describe, monitor",
            "fly" to "there is no command 'fly'; there are: ports",
            "-- ports" to "'ports' stands behind --, where no command does; leave -- out",
            "port" to "there is no command 'port'; did you mean ports? there are: ports",
            "chekc x" to "there is no command 'chekc'; did you mean check? there are: ports",
            "filter chek f.xml" to "there is no command 'chek'; did you mean check? there are: check",
            "filter" to "name a command: check, explain, convert",
            "ports --fly" to "Unknown option: '--fly'",
            "ports --baud fast" to "fast is not a whole number",
            "ports --baud 0" to "--baud is from 1 to",
            "monitor" to "Missing required parameter: 'PORT'",
            "monitor sim:x --mode sing" to "--mode is request or listen, not sing",
            "monitor sim:x --interval -1" to "--interval is from 0 to",
            "monitor sim:x --count many" to "'--count': many is not a whole number",
            "monitor sim:x --count 0" to "--count is at least 1, not 0",
            "monitor sim:x --protocol 3" to "--protocol is 1, 2 or auto, not 3",
            "request sim:x a --baud 0" to "--baud is from 1 to",
            "request sim:x a --timeout 0" to "--timeout is from 1 to",
            "request sim:x" to "Missing required parameter: 'MESSAGE'",
            "send sim:x a b" to "'b' is one argument too many",
            "send sim:x getPercepts" to "getPercepts is the request for percepts and no command: \"request sim:x getPercepts\" sends it",
            "ports sim:x" to "sim:x is no serial port, and nothing is known of it before it is opened",
            "filter explain f.json ;" to "there is no percept in ';'",
            "filter check" to "Missing required parameter: 'FILE'",
            "filter convert f.xml --to yaml" to "--to is xml, json, kotlin, not yaml",
            "filter convert f.xml" to "Missing required option: '--to=FORM'",
            "new" to "Missing required parameter: 'NAME'",
            "new -x" to "Unknown option: '-x'\n",
            "monitor --fly" to "Unknown option: '--fly'",
            "monitor --rwa" to "Unknown option: '--rwa'; did you mean --raw?",
            "monitor sim:x --secnds 3" to "Unknown option: '--secnds'; did you mean --seconds?",
            "monitor sim:x --modus=listen" to "Unknown option: '--modus=listen'; did you mean --mode?",
            "new ../up" to "a project's name begins with a letter",
        ).forEach { (line, reason) ->
            test("argo $line") {
                val said = argo(*line.split(' ').filter { it.isNotEmpty() }.toTypedArray())
                said.status shouldBe 2
                said.err shouldContain reason
                said.err shouldContain "--help lists the options"
                said.out.shouldBeEmpty()
            }
        }
    }

    test("an empty command is refused, as argo.act refuses it") {
        val said = argo("send", "sim:x", "")
        said.status shouldBe 2
        said.err shouldContain "a command has at least one character"
    }

    test("a name that no file can have is refused with what may be the reason") {
        val said = argo("filter", "check", "\u0000.xml")
        said.status shouldBe 2
        said.err shouldContain "has characters that no file name has here; if it exists, set a UTF-8 locale"
    }

    test("a port that is not there is named with those that are") {
        val said = argo("request", "ttyNoSuchBoard9", "getPercepts")
        said.status shouldBe 1
        said.err shouldContain "there is no port ttyNoSuchBoard9"
        said.err shouldNotContain "\tat "
    }

    test("ports names a device that is not there, lists the others, and fails") {
        val there = "/dev/zero"
        val said = argo("ports", "/dev/no-such-board", there)
        said.status shouldBe 1
        said.err shouldStartWith "there is no port /dev/no-such-board; there are: "
        said.out shouldContain there
        said.out shouldNotContain "no-such-board"
        argo("ports", "ttyNoSuchBoard9").out.shouldBeEmpty()
        argo("ports", there).status shouldBe 0
    }

    test("a file, a folder and a name without characters are no ports") {
        listOf("${tempfile()}", "${tempdir()}", "").forEach { name ->
            val said = argo("ports", name)
            said.status shouldBe 1
            said.out.shouldBeEmpty()
            said.err shouldStartWith "there is no port ${name.ifEmpty { "without a name" }}; there are: "
        }
    }

    test("the help of commands whose samples are not there says what they do, and where samples are found") {
        listOf("demo", "experiment", "sample").forEach { name ->
            val said = argo(name, "--help")
            said.status shouldBe 0
            said.out shouldStartWith "Usage: argo $name"
            said.out shouldContain "Its options cannot be listed: the samples are not there"
            argo(name).status shouldBe 1
        }
    }

    test("results that cannot be written make a command fail, whatever it did") {
        fun full(reason: String) = object : OutputStream() {
            override fun write(byte: Int): Unit = throw IOException(reason)
        }
        fun said(target: OutputStream, vararg arguments: String): Pair<Int, String> {
            val err = StringWriter()
            return run(arrayOf(*arguments), target, tools().setErr(PrintWriter(err, true))) to "$err"
        }
        val file = tempfile(suffix = ".json").apply { writeText("""{"rules": [{"predicate": "d"}]}""") }
        listOf(listOf("completion"), listOf("--help"), listOf("doctor", "--json"), listOf("filter", "check", "$file")).forEach { command ->
            val full = said(full("No space left on device"), *command.toTypedArray())
            full shouldBe (1 to "the results could not be written: No space left on device\n")
            said(full("Broken pipe"), *command.toTypedArray()) shouldBe (1 to "")
            said(OutputStream.nullOutputStream(), *command.toTypedArray()).second.shouldBeEmpty()
        }
        said(full("No space left on device"), "fly").first shouldBe 2
    }

    test("a file that cannot be made is reported with the folder at fault") {
        val folder = tempdir()
        val filter = folder.resolve("f.json").apply { writeText("""{"rules": [{"predicate": "d"}]}""") }
        fun convert(target: String) = argo("filter", "convert", "$filter", "--to", "xml", "-o", target)
        convert("$folder/none/f.xml") shouldBe Output(1, "", "there is no folder $folder/none\n")
        convert("$filter/f.xml") shouldBe Output(1, "", "$filter is no folder\n")
        convert("$filter") shouldBe Output(1, "", "$filter exists already, and is not overwritten\n")
        convert("$folder/f.xml").status shouldBe 0
        argo("monitor", "sim:not-asked-for", "--record", "$folder/none/f.rec") shouldBe Output(1, "", "there is no folder $folder/none\n")
        argo("filter", "explain", "$folder.xml", "d").status shouldBe 1
        val damaged = folder.resolve("drive.mcap").apply { writeText("no MCAP") }
        argo("replay", "$damaged") shouldBe Output(1, "", "$damaged is no recording of agents: it does not begin as an MCAP file\n")
        argo("replay", "$folder") shouldBe Output(1, "", "$folder is a folder, no file\n")
    }

    test("the version names the Java that runs it too") {
        val said = argo("--version")
        said.status shouldBe 0
        said.out shouldStartWith "ARGO "
        said.out shouldContain "Java ${Runtime.version().feature()}"
    }

    test("the completion script knows every command") {
        val script = argo("completion").out
        script shouldStartWith "#!/usr/bin/env bash"
        script.split(Regex("\\W+")) shouldContainAll tools().subcommands.keys.map { it.substringBefore('-') }
    }

    test("the page on the tools has a row for every command, and no other") {
        val row = Regex("^\\| `([a-z-]+(?: [a-z]+)?)", RegexOption.MULTILINE)
        val rows = row.findAll(Path.of("../docs/tools.md").readText()).map { it.groupValues[1] }.toList()
        val commands = tools().subcommands.flatMap { (name, command) ->
            command.subcommands.keys.map { "$name $it" }.ifEmpty { listOf(name) }
        }
        rows shouldContainExactlyInAnyOrder commands + "lsp" + "ros check" // argo.jar adds commands of other modules
    }
})
