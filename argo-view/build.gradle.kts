plugins {
    `java-library`
    alias(libs.plugins.kotlin.serialization)
}

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(libs.serialization.json) // what the page is sent
    testImplementation(libs.jason)
    testImplementation(libs.selenium) // tests open the page in a browser
}
