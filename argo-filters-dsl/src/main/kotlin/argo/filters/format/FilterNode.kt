package argo.filters.format

/** A value in a filter's document, with its position and its text for messages. XML and JSON documents both become such values. */
internal sealed class FilterNode(val position: Position, val words: String) {
    class Object(position: Position, val members: List<Member>) : FilterNode(position, "an object")

    class Array(position: Position, val items: List<FilterNode>) : FilterNode(position, "an array")

    /**
     * @property isText true if the scalar can be a text. In JSON, only a scalar in quotes can be a text. In XML, every scalar can be a
     *     text
     * @property isBare true if the scalar can be a number or a truth value. In JSON, only a scalar without quotes can be a number or a
     *     truth value. In XML, every scalar can be a number or a truth value
     */
    class Scalar(position: Position, val content: String, val isText: Boolean, val isBare: Boolean) :
        FilterNode(position, if (isText) "'$content'" else content)

    /** Replaces a missing or wrong value. The problem has been reported already. */
    class Refused(position: Position) : FilterNode(position, "")

    class Member(val name: String, val position: Position, val value: FilterNode, val words: String = "\"$name\" is ${value.words}")
}
