plugins {
    `java-library`
    alias(libs.plugins.kotlin.serialization)
}

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(libs.serialization.json) // writes the states that the page is sent
    compileOnly(project(":argo-tools")) // the tool view, which shows recordings; other projects do not need them
    compileOnly(project(":argo-recording"))
    compileOnly(libs.picocli)
    testImplementation(libs.jason)
    testImplementation(libs.selenium) // tests open the page in a browser
    testImplementation(project(":argo-tools"))
    testImplementation(project(":argo-recording"))
    testImplementation(project(":argo-testkit")) // tests record agents
    testImplementation(libs.picocli)
}
