package argo.check.project

import argo.check.ProjectCheck
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.maps.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.name
import kotlin.io.path.writeText

class ProjectReaderSpec : FunSpec({
    val root = tempdir().toPath()
    fun folder(vararg files: Pair<String, String>): Path = Files.createTempDirectory(root, "folder").toRealPath().apply {
        files.forEach { (name, text) -> resolve(name).apply { parent.createDirectories() }.writeText(text) }
    }

    test("each folder with a project file is a project, and programs elsewhere are one together") {
        val folder = folder(
            "a/a.mas2j" to "MAS a { agents: bob; }", "a/src/asl/bob.asl" to "", "b/b.jcm" to "mas b {}", "b/eve.asl" to "", "c.asl" to "",
            "d/e.asl" to "", "build/f.asl" to "",
        )
        val found = ProjectReader().projectsIn(folder).map { project -> project.root.name to project.programs.keys.map { it.name } }
        found shouldContainExactly listOf(folder.name to listOf("c.asl", "e.asl"), "a" to listOf("bob.asl"), "b" to listOf("eve.asl"))
        ProjectReader().projectOf(folder.resolve("a/src/asl/bob.asl")).root shouldBe folder.resolve("a")
    }

    test("an agent's program is found on the source path, and programs that it includes are parts of it") {
        val folder = folder(
            "a.mas2j" to
                "MAS a {\n agents: bob x.asl [argo_view=8080, verbose=1] agentArchClass argo.Arch #2; eve;\n aslSourcePath: \"agents\";\n}",
            "agents/x.asl" to "{ include(\"parts/y.asl\") }", "agents/parts/y.asl" to "{ include(\"z.asl\") }", "agents/parts/z.asl" to "",
            "agents/eve.asl" to "{ include(\"\$jar/none.asl\") }",
        )
        val project = ProjectReader().projectsIn(folder).single()
        val (bob, eve) = project.masFiles.single().agents
        bob.names shouldContainExactly listOf("bob1", "bob2")
        bob.options.map { "${it.name}=${it.value}" } shouldContainExactly listOf("argo_view=8080", "verbose=1")
        bob.isArgo shouldBe true
        val parts = project.partsOf(folder.resolve("agents/parts/z.asl"))
        parts.programs.map { it.path.name }.sorted() shouldContainExactly listOf("x.asl", "y.asl", "z.asl")
        parts.isOpen shouldBe false
        project.agentsOf(folder.resolve("agents/parts/z.asl")) shouldContainExactly listOf(bob)
        project.partsOf(checkNotNull(project.sourceOf(project.masFiles.single(), eve))).isOpen shouldBe true
    }

    test("a text that an editor has takes the place of the file") {
        val folder = folder("a.mas2j" to "MAS a { agents: bob; }", "bob.asl" to "a.")
        val project = ProjectReader().projectsIn(folder).single().with(folder.resolve("bob.asl"), "b.")
        project.programs.getValue(folder.resolve("bob.asl")).program.text shouldBe "b."
    }

    test("what a sketch and a board in Python say of the robot is known") {
        val robot = ProjectReader().projectsIn(
            folder(
                "a.asl" to "",
                "a/b.ino" to "javino.describe(F(\"dist(cm 0..400)\")); javino.act[\"stop\"] = stop; javino.onAction(\"say\", say);",
                "c.py" to "board.on_action(\"speed\", f, 1)\nboard.perceive(look, \"light(0..1023)\", \"ready\")",
            ),
        ).single().robot
        robot.percepts.map { "$it" } shouldContainExactly listOf("dist(cm 0..400)", "light(0..1023)", "ready")
        robot.actions.map { "$it" } shouldContainExactly listOf("stop/0", "say/*", "speed/1")
    }

    test("what describes the robot has its place, and what cannot be read its reason") {
        val robot = ProjectReader().projectsIn(
            folder(
                "a.asl" to "", "b.ino" to "javino.describe( F(\"ready\") );\njavino.onAction(\"go\", [](const JavinoArguments &a) {});",
                "percepts" to "  dist(cm 0..9) # near\nDist\n",
            ),
        ).single().robot
        robot.described.map { "${it.meaning} ${it.file.path.name}:${it.file.lines.position(it.span.start)}" } shouldContainExactly
            listOf("dist(cm 0..9) percepts:1:3", "ready b.ino:1:21")
        robot.registered.map { "${it.meaning} ${it.file.lines.position(it.span.start)}" } shouldContainExactly listOf("go/* 2:18")
        "${robot.unreadable.single()}" shouldContain "percepts: \"Dist\" is no functor"
    }

    test("files of percepts are called percepts, or end so") {
        val folder = folder("a.asl" to "", "percepts" to "a(_)", "left.percepts" to "\uFEFFb(_)", "percepts.txt" to "c")
        val robot = ProjectReader().projectsIn(folder).single().robot
        robot.percepts.map { it.functor() } shouldContainExactly listOf("b", "a")
    }

    test("what a mapping of ROS says of the robot is known, except for what is usual for a type") {
        fun robot(battery: String) = ProjectReader().projectsIn(
            folder(
                "a.asl" to "",
                "robot.ros.yaml" to "percepts:\n  - /sonar sensor_msgs/Range -> dist(f, round(range*100, 1)) if range < 3\n$battery" +
                    "commands: # of the robot\n  - move(V, W) -> /cmd_vel geometry_msgs/Twist\n" +
                    "  - stop -> service /stop std_srvs/Trigger # now\n" +
                    "  - dock -> action /dock my_msgs/DockAction within 5 s feedback docking(percent) answer at(place)\n",
            ),
        ).single().robot
        robot("").percepts.map { "$it" } shouldContainExactly listOf("dist(_, _)", "docking(_)")
        robot("").actions.map { "$it" } shouldContainExactly listOf("move/2", "stop/0", "dock/0")
        robot("").isComplete shouldBe true
        robot("  - /battery sensor_msgs/BatteryState\n").isComplete shouldBe false
    }

    test("a recording shows percepts that no other file describes, and that there may be more") {
        val recording = "javino-recording 1\n8\tout\tgetPercepts\n90\tin\tdist(front,70);say(\"a;b\");Bad(1)\n95\tin\tdist(back,7)\n"
        val robot = ProjectReader().projectsIn(folder("a.asl" to "", "drive.rec" to recording, "percepts" to "say(_)\n")).single().robot
        robot.percepts.map { "$it" } shouldContainExactly listOf("say(_)", "dist(_, _)")
        robot.isComplete shouldBe false
    }

    test("a file is a filter if its folder, an agent or its rules say so, and else a document of another kind") {
        val project = ProjectReader().projectsIn(
            folder(
                "a.asl" to "+a <- argo.change_filter(near); argo.change_filter(\"far.json\").",
                ".eslintrc.json" to "{\"rules\": {\"semi\": 2}}",
                "vectors.json" to "{\"of\": {\"rules\": [{\"predicate\": \"dist\"}]}}",
                "broken.json" to "{\"rules\": [", "near.json" to "{", "far.json" to "[]", "filters/slip.json" to "{\"ruels\": []}",
                "whole.json" to "{\"keep\": true, \"rules\": [{\"predicate\": \"dist\"}]}",
                "page.xml" to "<page>Write &lt;filter> in <![CDATA[<PerceptionFilter>]]></page>",
                "root.xml" to "<?xml version=\"1.0\"?>\n<!-- of the robot -->\n<PerceptionFilter/>",
            ),
        ).single()
        project.filters.map { it.path.name } shouldContainExactly
            listOf("far.json", "slip.json", "near.json", "root.xml", "whole.json")
    }

    test("links are followed, once around, and a link to nowhere is left out, and told of") {
        val shared = folder("b.asl" to "b.")
        val folder = folder("a.asl" to "a.")
        Files.createSymbolicLink(folder.resolve("shared"), shared)
        Files.createSymbolicLink(folder.resolve("loop"), folder)
        Files.createSymbolicLink(folder.resolve("gone.asl"), folder.resolve("none"))
        Files.createSymbolicLink(folder.resolve(".#a.asl"), folder.resolve("none"))
        val project = ProjectReader().projectsIn(folder).single()
        project.programs.keys.map { it.name } shouldContainExactly listOf("a.asl", "b.asl")
        project.leftOut shouldBe mapOf(folder.resolve("gone.asl") to "it is no regular file")
    }

    test("a linked folder beside its original is read once, as the original") {
        val folder = folder("original/a.asl" to "a.")
        Files.createSymbolicLink(folder.resolve("also"), folder.resolve("original"))
        ProjectReader().projectsIn(folder).single().programs.keys.map { "${folder.relativize(it)}" } shouldContainExactly
            listOf("original/a.asl")
    }

    test("a folder that cannot be read is told of by the project around it").config(enabled = System.getProperty("user.name") != "root") {
        val folder = folder("a/a.mas2j" to "MAS a { agents: b; }", "a/b.asl" to "", "a/closed/c.asl" to "")
        val closed = folder.resolve("a/closed").toFile()
        try {
            closed.setReadable(false)
            ProjectReader().projectsIn(folder).single().leftOut.keys.map { it.name } shouldContainExactly listOf("closed")
        } finally {
            closed.setReadable(true)
        }
    }

    test("files beyond the limit of a folder are left out, and told of") {
        val folder = folder("a.asl" to "a.", "b.asl" to "b.")
        fun leftOut(maxFiles: Int) = ProjectReader(maxFiles).projectsIn(folder).single().leftOut
        leftOut(1) shouldBe mapOf(folder to "it has more than 1 files, and the others are left out")
        leftOut(2).shouldBeEmpty()
    }

    test("a file that is too large is left out, and told of") {
        val folder = folder("a.asl" to "a.", "big.py" to "# ${"x".repeat(2_000_001)}")
        val project = ProjectReader().projectsIn(folder).single()
        ProjectCheck(project).findings().single().run { rule shouldBe "left-out"; what shouldContain "more than 2000000 bytes" }
        ProjectReader().projectsIn(folder("a.asl" to "a.")).single().leftOut.shouldBeEmpty()
    }
})
