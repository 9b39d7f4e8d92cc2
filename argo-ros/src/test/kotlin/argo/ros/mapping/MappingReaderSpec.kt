package argo.ros.mapping

import argo.filters.jason.PerceptReader
import argo.ros.bridge.operationIn
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.StringTerm
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Files
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

private val CONSTANTS = mapOf("CHARGING" to JsonPrimitive(1))

class MappingReaderSpec : FunSpec({
    fun percept(rule: String, message: String): String? {
        val read = mappingOf("percepts:\n  - $rule", "t").percepts.single()
        val scope = MessageScope(checkNotNull(operationIn(message)))
        return (read.perceptIn(scope) as? Value.Symbol)?.text
    }

    fun reason(rule: String, message: String): String {
        val read = mappingOf("percepts:\n  - $rule", "t").percepts.single()
        return (read.perceptIn(MessageScope(checkNotNull(operationIn(message)))) as Value.None).why
    }

    fun refusal(text: String) = shouldThrow<MappingException> { mappingOf(text, "robot.ros.yaml") }.message.orEmpty()

    context("a percept") {
        test("has fields, calculations, atoms, strings and functions for arguments") {
            val range = """{"range": 0.375, "header": {"frame_id": "left"}}"""
            percept("/sonar/front sensor_msgs/Range -> dist(f, range*100)", range) shouldBe "dist(f,37.5)"
            percept("/sonar/front sensor_msgs/msg/Range -> dist(f, round(range*100), \"a b\", -1)", range) shouldBe "dist(f,38,\"a b\",-1)"
            percept("/sonar/front sensor_msgs/Range -> dist(header.frame_id, (range + 1) / 2 - 0.5)", range) shouldBe
                "dist(\"left\",0.1875)"
            percept("/a my_msgs/A -> a(b[1].c, 'front', at(d))", """{"b": [{}, {"c": true}], "d": "x"}""") shouldBe
                "a(true,front,at(\"x\"))"
            percept("/a my_msgs/A -> 'a'(b)".replace("'a'", "a"), """{"b": [1, 2.5]}""") shouldBe "a([1,2.5])"
        }
        test("without a value for each argument is none") {
            listOf("""{"range": null}""", "{}", """{"range": "far"}""", """{"range": {}}""").forEach {
                percept("/sonar sensor_msgs/Range -> dist(range * 1)", it) shouldBe null
            }
            percept("/sonar sensor_msgs/Range -> dist(1/range)", """{"range": 0}""") shouldBe null
        }
        test("may have conditions") {
            val rule = "/sonar sensor_msgs/Range -> near if range < max_range / 2 and range >= min_range"
            percept(rule, """{"range": 1, "min_range": 0, "max_range": 4}""") shouldBe "near"
            percept(rule, """{"range": 3, "min_range": 0, "max_range": 4}""") shouldBe null
            percept(rule, """{"range": 1, "max_range": 4}""") shouldBe null
            percept("/s std_msgs/String -> go if data == \"go\"", """{"data": "go"}""") shouldBe "go"
            percept("/s std_msgs/Bool -> go if data == 'true'", """{"data": true}""") shouldBe "go"
        }
        test("may have conditions with and, or, not, brackets, and fields that are true or false") {
            fun isMet(condition: String, message: String) = percept("/a my_msgs/A -> a if $condition", message) == "a"
            isMet("a and not b or c", """{"a": true, "b": false, "c": false}""") shouldBe true
            isMet("a and not b or c", """{"a": true, "b": true, "c": true}""") shouldBe true
            isMet("a and not (b or c)", """{"a": true, "b": false, "c": true}""") shouldBe false
            isMet("not x < 1", """{"x": 1}""") shouldBe true
            isMet("x == 1 or y == 1", """{"y": 1}""") shouldBe true // one decisive operand is enough
            isMet("x == 1 and y == 1", """{"y": 1}""") shouldBe false
            isMet("word == \"it's \\\"\\\\\"", """{"word": "it's \"\\"}""") shouldBe true
            percept("/a my_msgs/A -> a(x < 1, true)", """{"x": 0}""") shouldBe "a(true,true)"
        }
        test("may have sectors and sums of lists") {
            val scan = """{"ranges": [5, 1, null, 7, 2, 6]}"""
            fun value(expression: String) = percept("/scan sensor_msgs/LaserScan -> v($expression)", scan)
            value("min(ranges[0:2])") shouldBe "v(1)"
            value("min(ranges[-2:2])") shouldBe "v(1)"
            value("ranges[4:1]") shouldBe "v([2,6,5])"
            value("ranges[3:]") shouldBe "v([7,2,6])"
            value("ranges[:2]") shouldBe "v([5,1])"
            value("ranges[-1]") shouldBe "v(6)"
            value("len(ranges), len(ranges[1:3]), sum(ranges), mean(ranges[:2])") shouldBe "v(6,2,21,3)"
            value("min(ranges[0], ranges[3], 6) + abs(-1) + floor(1.9) + ceil(0.2)") shouldBe "v(8)"
            value("round(deg(3.14159))") shouldBe "v(180)"
            percept("/found my_msgs/Found -> best(max(all[:].score))", """{"all": [{"score": 0.2}, {"score": 0.7}]}""") shouldBe "best(0.7)"
        }
        test("of any type may be left to the names of its fields, but for the header") {
            val joints = """{"header": {}, "name": ["a"], "position": [1.5], "on": {"x": null}}"""
            percept("/joint_states sensor_msgs/JointState", joints) shouldBe
                "joint_states(name([\"a\"]),position([1.5]),on([x(null)]))"
            percept("/tick std_msgs/Empty", "{}") shouldBe "tick"
        }
        test("may go by constants of its type") {
            val text = "percepts:\n  - /b sensor_msgs/BatteryState -> charging if power_supply_status == CHARGING"
            val rule = mappingOf(text, "t").percepts.single()
            fun scope(status: Int) = MessageScope(JsonObject(mapOf("power_supply_status" to JsonPrimitive(status))), emptySet(), CONSTANTS)
            rule.perceptIn(scope(1)) shouldBe Value.Symbol("charging")
            (rule.perceptIn(scope(2)) is Value.Symbol) shouldBe false
        }
        test("of a usual type may be left to it") {
            percept("/robot/battery sensor_msgs/BatteryState", """{"percentage": 0.5}""") shouldBe "battery(0.5)"
            percept("/scan sensor_msgs/LaserScan", """{"ranges": [2, null, 0.5]}""") shouldBe "scan(0.5)"
            val pose = """{"position": {"x": 1, "y": 2}, "orientation": {"x": 0, "y": 0, "z": 1, "w": 0}}"""
            percept("/odom nav_msgs/Odometry", """{"pose": {"pose": $pose}}""") shouldBe "odom(1,2,${Math.PI})"
            percept("/ready std_msgs/msg/Bool", """{"data": false}""") shouldBe "ready(false)"
            percept("/turtle1/pose turtlesim/Pose -> at(round(x), round(y))", """{"x": 5.54, "y": 5.5}""") shouldBe "at(6,6)"
        }
        test("keeps text as it is, whatever is in it") {
            for (text in listOf("C:\\robot\\map.yaml", "\\d+", "{\"a\": \"x\\ny\"}", "☃", "two\nlines\r", "\\")) {
                val message = JsonObject(mapOf("data" to JsonPrimitive(text)))
                val term = PerceptReader.read(checkNotNull(percept("/says std_msgs/String", "$message"))).getTerm(0)
                (term as StringTerm).string shouldBe text
            }
        }
        test("has lists of up to 1,000 items, in which null stands for what was not measured") {
            percept("/scan sensor_msgs/LaserScan -> scan(ranges)", """{"ranges": [1, null, 0.5, NaN]}""") shouldBe "scan([1,null,0.5,null])"
            val scan = (1..1_000).joinToString(",", "[", "]")
            percept("/scan sensor_msgs/LaserScan -> scan(ranges)", """{"ranges": $scan}""") shouldBe "scan($scan)"
        }
        test("has messages as lists of their fields") {
            percept("/s a_msgs/Found -> found(all)", """{"all": [{"x": 1, "At": {"if": "left"}}, {}]}""") shouldBe
                "found([[x(1),'At'(['if'(\"left\")])],[]])"
        }
        test("has integers that Jason's numbers hold exactly, and calculates with others") {
            percept("/id std_msgs/Int64", """{"data": 9007199254740992}""") shouldBe "id(9.007199254740992E15)"
            percept("/id std_msgs/Int64 -> id(data / 1000)", """{"data": 9007199254741993}""") shouldBe "id(9.007199254741992E12)"
            percept("/id std_msgs/Int64 -> id if data > 5", """{"data": 9007199254740993}""") shouldBe "id"
        }
        test("compares text with strings and atoms alike") {
            for (quoted in listOf("'go'", "\"go\"")) {
                percept("/s std_msgs/String -> go if data == $quoted", """{"data": "go"}""") shouldBe "go"
                percept("/s std_msgs/String -> go if data != $quoted", """{"data": "go"}""") shouldBe null
            }
            percept("/s std_msgs/String -> go if data == 'Go on'", """{"data": "Go on"}""") shouldBe "go"
            percept("/s std_msgs/Bool -> go if data == \"true\"", """{"data": true}""") shouldBe "go"
            percept("/s std_msgs/String -> go if data == 'true'", """{"data": "true"}""") shouldBe "go"
        }
        context("that is left out has a reason:") {
            val pose = "/odom nav_msgs/Odometry -> at(pose.pose.positon.x)"
            val many = (0..1_000).joinToString(",", "[", "]")
            listOf(
                Triple(pose, """{"pose": {"pose": {"position": {}}}}""", "1 of at: pose.pose has no field positon; it has position"),
                Triple("/s sensor_msgs/Range -> d(range)", """{"range": null}""", "range: it is null; bridges write so for a number"),
                Triple("/s sensor_msgs/Range -> d(1/range)", """{"range": 0}""", "a number is infinite, or the result of no calculation"),
                Triple("/s sensor_msgs/Range -> d(range*2)", """{"range": "far"}""", "* calculates with numbers, not with the text"),
                Triple("/s sensor_msgs/LaserScan -> scan(ranges)", """{"ranges": $many}""", "has 1001 items, and a list has 1000 at most"),
                Triple("/s a_msgs/Found -> found(all[1].x)", """{"all": [{"x": 1}]}""", "the list all has 1 items, and no [1]"),
                Triple("/s a_msgs/Found -> found(all[0:3])", """{"all": [1]}""", "the list all has 1 items, and no [0:3]"),
                Triple("/s a_msgs/Found -> found(all.x)", """{"all": [{"x": 1}]}""", "all is a list; take an item of it, as all[0].x"),
                Triple("/s a_msgs/Found -> found(sum(all))", """{"all": []}""", "sum takes a list with numbers, or several"),
                Triple("/s a_msgs/Found -> found if x", """{"x": 1}""", "a condition is true or false, and not the number 1"),
                Triple("/s a_msgs/Found -> found if x == OPEN", """{"x": 1}""", "no constant OPEN is known; rosapi describes constants"),
                Triple("/s a_msgs/Found -> found(all[0].x)", """{"all": [{"x": null}]}""", "argument 1 of found: all[0].x: it is null"),
                Triple("/s sensor_msgs/LaserScan", """{"ranges": [null]}""", "min takes a list with numbers, or several numbers"),
                Triple("/s std_msgs/Int64 -> id(data)", """{"data": 9007199254740993}""", "9007199254740993 is an integer that Jason's"),
                Triple("/s std_msgs/Bool -> go if data == 'True'", """{"data": true}""", "== cannot compare the atom true with the atom"),
                Triple("/s std_msgs/String -> go if data == true", """{"data": "on"}""", "the atom true; write \"true\" or \"false\""),
                Triple("/s a_msgs/A -> go(all)", """{"all": {"it's": 1}}""", "it has a field whose name no agent can read"),
                Triple("/s a_msgs/A", """{"all": "${"x".repeat(10_001)}"}""", "a text in it has 10001 characters"),
                Triple("/s std_msgs/String -> go if data == 5", """{"data": "5"}""", "== cannot compare the text \"5\" with the number 5"),
                Triple("/s std_msgs/String -> go if data > 'a'", """{"data": "b"}""", "> cannot compare the text \"b\" with the atom a"),
            ).forEach { (rule, message, why) -> test("$rule of ${message.take(60)}") { reason(rule, message) shouldContain why } }
        }
        test("of which a condition does not hold is left out without a reason") {
            val rule = mappingOf("percepts:\n  - /s sensor_msgs/Range -> near if range < 1 and max_range > 1", "t").percepts.single()
            (rule.perceptIn(MessageScope(checkNotNull(operationIn("""{"range": 2}""")))) is Value.None) shouldBe false
        }
        test("may hold for a time") {
            mappingOf("percepts:\n- /a std_msgs/Bool -> a for 1.5 s", "t").percepts.single().forMs shouldBe 1500
        }
    }

    test("comments, blank lines and both orders of the keys are read") {
        val commands = "---\n# a robot\ncommands:\n- stop -> service /stop std_srvs/Empty # at once\n"
        val mapping = mappingOf("$commands\npercepts:\n  - /a std_msgs/Bool\n", "t")
        (mapping.commands.single().name to mapping.percepts.single().topic) shouldBe ("stop" to "/a")
    }

    context("mistakes are refused with line and column:") {
        listOf(
            "percepts:\n  - /sonar sensor_msgs/Range -> dist(f, rnage)" to "2:41: sensor_msgs/Range has no field rnage; is range meant?",
            "percepts:\n  - /sonar sensor_msgs/Range -> dist(f, rang.e)" to "2:41: sensor_msgs/Range has no field rang; it has header",
            "percepts:\n  - sonar" to "robot.ros.yaml:2:10: expected a type",
            "percepts:\n  - /sonar sensor_msgs/Range -> Dist(range)" to "robot.ros.yaml:2:33: 'Dist' is no functor",
            "percepts:\n  - /sonar sensor_msgs/Range -> dist(range" to "expected ')' behind the arguments, but found the end of the line",
            "percepts:\n  - /sonar sensor_msgs/Range -> dist(range) iff" to "2:45: expected -> LITERAL, then if CONDITION, then for TIME",
            "percepts:\n  - /sonar sensor_msgs/Range -> dist(range) if range + 1" to "2:48: a condition compares values by <=",
            "percepts:\n  - /sonar sensor_msgs/Range -> near if range < 1 or 5" to "2:54: a condition compares values by <=",
            "percepts:\n  - /a std_msgs/Bool -> a if data = true" to "but found 'true'; values are compared by ==",
            "percepts:\n  - /a my_msgs/A -> a(rond(b))" to "2:23: rond is no function; is round meant? A literal would be written",
            "percepts:\n  - /a my_msgs/A -> a(count(b))" to "count is no function; is len meant?",
            "percepts:\n  - /a my_msgs/A -> a if foo(b) > 1" to "foo is no function; there are round, floor",
            "percepts:\n  - /a my_msgs/A -> a(foo(b) + 1)" to "foo is no function; there are round, floor",
            "percepts:\n  - /a my_msgs/A -> a(b[3:3])" to "the sector [3:3] has no items",
            "percepts:\n  - /a my_msgs/A -> a(b[x])" to "expected ':' in the numbers of items, as in [0], [-1] or [0:90]",
            "percepts:\n  - /a my_msgs/A -> a(\"\\d\")" to "behind \\ in a string there is \" or \\, and not 'd'",
            "percepts:\n  - /a my_msgs/A a(b)" to "expected -> LITERAL, then if CONDITION, then for TIME or all, but found 'a(b)'",
            "percepts:\n  - /Ab my_msgs/A" to "'Ab' is no name for a percept; write one behind '->', as -> dist(FIELD)",
            "percepts:\n  - tf map base" to "expected '->' and a literal, as -> pose(x, y, yaw)",
            "percepts:\n  - tf map -> pose(x, y)" to "expected two frames, as tf map base_link",
            "percepts:\n  - tf map base -> pose(x, y, yaw) all" to "the pose of a frame is no event",
            "percepts:\n  - /odom nav_msgs/Odometry -> pose(x, y)" to "2:37: x is no field of nav_msgs/Odometry, which has header",
            "percepts:\n  - tf map base -> pose(x, y, theta)" to "theta is no field of the pose of a frame",
            "percepts:\n  - /imu sensor_msgs/Imu -> heading(yaw)" to "yaw is a function, as yaw(FIELD), and no field of sensor_msgs/Imu",
            "percepts:\n  - /scan sensor_msgs/LaserScan -> free(ranges(0))" to "ranges is a field of sensor_msgs/LaserScan, and no literal",
            "percepts:\n  - /scan sensor_msgs/LaserScan -> free(average(ranges))" to "average is no function; is mean meant?",
            "percepts:\n  - /imu sensor_msgs/Imu -> heading(atan2(orientation.z))" to "atan2 is no function; there are round",
            "commands:\n  - turn(W) -> /cmd_vel geometry_msgs/Twist" to "expected the fields that the arguments of turn are for",
            "commands:\n  - x(V) -> /say std_msgs/String(data = speed(V))" to "speed is no function; a literal would be written 'speed'(…)",
            "percepts:\n  - tf map base -> pose(x, yow)" to "the pose of a frame has no field yow; is yaw meant?",
            "percepts:\n  - /sonar sensor_msgs/Range -> dist(range + 1) for 5" to "expected ms or s",
            "percepts:\n  - /a std_msgs/Bool\n  - /a std_msgs/String" to "3:5: the topic /a has the type std_msgs/Bool in line 2",
            "commands:\n  - move(v) -> /cmd_vel geometry_msgs/Twist" to "robot.ros.yaml:2:10: v is no variable",
            "commands:\n  - move(V) -> /cmd_vel geometry_msgs/Twist(linear.x = W)" to "W is no argument of the command; it has V",
            "commands:\n  - move(V) -> /cmd_vel geometry_msgs/Twist(linear.x = V, linear = V)" to "linear has a value already, by linear.x",
            "commands:\n  - stop -> /cmd_vel geometry_msgs/Twist(linear.x = 0, linear.x = 1)" to "linear.x is given a value twice",
            "commands:\n  - move(V) -> service /move my_msgs/Move" to "expected the fields that the arguments of move are for",
            "commands:\n  - dock -> action /dock my_msgs/Dock" to "robot.ros.yaml:2:26: my_msgs/Dock is no action",
            "commands:\n  - a -> /a std_msgs/Empty\n  - a -> /b std_msgs/Empty" to "3:5: the command a/0 stands in line 2 already",
            "commands:\n  - a -> /a std_msgs/Bool(data: 1)" to "robot.ros.yaml:2:31: an item has no ':'",
            "topics:\n  - /a std_msgs/Bool" to "robot.ros.yaml:1:1: expected 'percepts:' or 'commands:', and below them",
            "percepts: /a" to "expected nothing behind 'percepts:'",
            "- /a std_msgs/Bool" to "this item is below neither",
            "percepts:\n  - \"/a std_msgs/Bool\"" to "an item does not begin with \"",
            "commands:\n  - a -> /a std_msgs/Int64(data = 9007199254740993)" to "9007199254740993 is a number that cannot be kept exactly",
            "percepts:\n\t- /a std_msgs/Bool" to "robot.ros.yaml:2:1: expected blanks, but found a tabulator",
            "percepts:\n  -\t/a std_msgs/Bool" to "robot.ros.yaml:2:4: expected blanks, but found a tabulator",
            "percepts:\n  - /a\tstd_msgs/Bool # a\ttabulator" to "robot.ros.yaml:2:7: expected blanks, but found a tabulator",
            "percepts:\n  - /a std_msgs/Bool -> a for 1 s all" to "2:35: a percept of all messages is an event",
            "commands:\n  - a(V, W) -> /a geometry_msgs/Twist(linear.x = V)" to "2:5: the argument W of a is used nowhere; write FIELD = W",
            "commands:\n  - a -> /a std_msgs/Empty answer data" to "2:28: nobody answers a message of a topic",
            "commands:\n  - a -> service /a std_srvs/Empty feedback at(x)" to "only actions have feedback",
            "commands:\n  - a -> service /a std_srvs/Empty anser data" to "expected within TIME, then feedback LITERAL, then answer VALUE",
            "" to "it is empty",
        ).forEach { (text, message) ->
            test(text.lines().last().trim().ifEmpty { "an empty file" }) { refusal(text) shouldContain message }
        }
        test("all at once") {
            refusal("percepts:\n  - a\n  - b").lines().size shouldBe 2
        }
    }

    test("rules whose percepts an agent cannot tell apart are doubted, unless they mean the same or exclude each other") {
        fun doubts(vararg rules: String) = mappingOf(rules.joinToString("\n", "percepts:\n") { "  - $it" }, "t").doubts
        doubts("/a sensor_msgs/Range -> dist(f, range)", "/b sensor_msgs/Range -> dist(f, range*100)").single() shouldContain
            "t: lines 2 and 3 give percepts dist/2 that an agent cannot tell apart"
        doubts("/a/range sensor_msgs/Range", "/b/range sensor_msgs/Range").size shouldBe 1
        doubts("/a sensor_msgs/LaserScan -> free(ranges[0])", "/a sensor_msgs/LaserScan -> free(ranges[1])").size shouldBe 1
        doubts("/a sensor_msgs/Range -> dist(f, range)", "/b sensor_msgs/Range -> dist(b, range)") shouldBe emptyList()
        doubts("/a std_msgs/Bool -> hit if data", "/b std_msgs/Bool -> hit if data") shouldBe emptyList()
        doubts("/a my_msgs/A -> speed(x) if fast", "/a my_msgs/A -> speed(y) if not fast") shouldBe emptyList()
    }

    test("a percept that is the same for each message is doubted, unless it is an event, or ends") {
        fun doubts(rule: String) = mappingOf("percepts:\n  - $rule", "t").doubts
        doubts("/a std_msgs/Empty -> pressed").single() shouldContain "t: line 2: each message of /a gives the same percept pressed"
        listOf("/a my_msgs/A", "/a std_msgs/Empty -> pressed all", "/a std_msgs/Empty -> alive for 2 s", "tf map base -> located")
            .forEach { doubts(it) shouldBe emptyList() }
    }

    test("a mapping is found in its directory, then on the class path, and nowhere else") {
        val directory = createTempDirectory("argo-ros")
        val file = directory.resolve("robot.ros.yaml").apply { writeText("percepts:\n  - /a std_msgs/Bool") }
        findMapping("robot", directory).source shouldBe "$file"
        shouldThrow<MappingException> { findMapping("other", directory) }.message shouldContain "there is no such file in $directory"
        shouldThrow<MappingException> { findMapping("../robot", directory.resolve("inner")) }.message shouldContain
            "is no name of a mapping"
        Files.delete(file)
        Files.delete(directory)
    }
})
